#include "simplify/quadric.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace foldwright {
namespace {

// Directions in which the sum grows by less than this share of the steepest one are free: planes
// that are within some two degrees of one plane say nothing of where in it a point should lie.
constexpr double kFree = 1e-3;

}  // namespace

void Quadric::add_plane(const Vec3& normal, const Vec3& point, double weight) {
  const double offset = -normal.dot(point);
  xx_ += weight * normal.x() * normal.x();
  xy_ += weight * normal.x() * normal.y();
  xz_ += weight * normal.x() * normal.z();
  yy_ += weight * normal.y() * normal.y();
  yz_ += weight * normal.y() * normal.z();
  zz_ += weight * normal.z() * normal.z();
  b_ += weight * offset * normal;
  c_ += weight * offset * offset;
}

Quadric& Quadric::operator+=(const Quadric& other) {
  xx_ += other.xx_, xy_ += other.xy_, xz_ += other.xz_;
  yy_ += other.yy_, yz_ += other.yz_, zz_ += other.zz_;
  b_ += other.b_;
  c_ += other.c_;
  return *this;
}

double Quadric::at(const Vec3& p) const {
  const double sum = p.x() * (xx_ * p.x() + 2 * (xy_ * p.y() + xz_ * p.z())) +
                     p.y() * (yy_ * p.y() + 2 * yz_ * p.z()) + zz_ * p.z() * p.z() + 2 * b_.dot(p) +
                     c_;
  return std::max(sum, 0.0);  // rounding
}

Vec3 Quadric::least_near(const Vec3& start, const Vec3* across) const {
  Eigen::Matrix3d a;
  a << xx_, xy_, xz_, xy_, yy_, yz_, xz_, yz_, zz_;
  Vec3 slope = a * start + b_;
  if (across) {
    const Eigen::Matrix3d within = Eigen::Matrix3d::Identity() - *across * across->transpose();
    a = within * a * within;
    slope = within * slope;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(a);
  const double least = kFree * axes.eigenvalues()[2];
  Vec3 place = start;
  for (int i = 0; i < 3; ++i) {
    const double growth = axes.eigenvalues()[i];
    if (growth <= least) continue;
    const Vec3 axis = axes.eigenvectors().col(i);
    place -= axis.dot(slope) / growth * axis;
  }
  return place;
}

}  // namespace foldwright
