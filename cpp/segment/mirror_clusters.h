#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace foldwright {

/// The share of points whose image lies in the cluster that holds most images of their own cluster.
/// `images`: per point the one that lies where its mirror image is. `labels`: from 0.
double mirrored_share(std::span<const int> labels, std::span<const int> images);

/// Makes clusters of points mirror each other where they nearly do.
///
/// Two clusters are partners when most of each one's images lie in the other; a cluster may be its
/// own partner. Points of clusters with a partner are assigned anew, each together with its image:
/// to the cluster for which the squared distances of the point from its centre, and of the image
/// from the centre of its partner, have the least sum; until nothing changes, at most ten times.
/// Clusters without a partner keep their points, and none is lost.
/// `points`: one per row. `labels`: from 0 without gaps.
std::vector<int> mirror_clusters(const Eigen::MatrixXd& points, std::span<const int> images,
                                 std::vector<int> labels);

}  // namespace foldwright
