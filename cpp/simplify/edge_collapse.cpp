#include "simplify/edge_collapse.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Tools/Utils/HeapT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "simplify/crossing_guard.h"
#include "simplify/face_shape.h"
#include "simplify/surface_quadrics.h"

namespace foldwright {
namespace {

using Connectivity = OpenMesh::TriConnectivity;
using VertexHandle = Connectivity::VertexHandle;
using EdgeHandle = Connectivity::EdgeHandle;
using HalfedgeHandle = Connectivity::HalfedgeHandle;

// A place further from an edge than this many of its lengths is due to nearly parallel planes.
constexpr double kFurthest = 1;

// A collapse moves nothing when its error is below this share of the fourth power of the edge:
// rounding. It comes before all that do, so that flat regions do not lose a corner to keep better
// triangles: within a region these are not folded. Their shapes only decide among such collapses.
constexpr double kNothing = 1e-9;
constexpr double kFlatShapes = 1e-9;

// What does not belong onto the plane of symmetry keeps this share of the edge off it.
constexpr double kOffPlane = 0.05;

// Above this number of faces those that could run through others are small, and many to look at.
constexpr int kGuardedFaces = 30'000;

/// An edge that may be collapsed.
struct Candidate {
  double cost;
  int edge;
};

/// Candidates by their costs. An edge is in it once at most: most change several times before it is
/// their turn.
class EdgeQueue {
 public:
  explicit EdgeQueue(std::size_t edges) : places_(edges, -1), heap_(Order{&places_}) {
    heap_.reserve(edges);
  }
  EdgeQueue(const EdgeQueue&) = delete;  // the heap knows where `places_` is

  bool empty() const { return heap_.empty(); }
  Candidate first() const { return heap_.front(); }
  void drop_first() { heap_.pop_front(); }
  /// Puts an edge in, in place of itself.
  void put(const Candidate& candidate) {
    if (heap_.is_stored(candidate)) heap_.remove(candidate);
    heap_.insert(candidate);
  }

 private:
  struct Order {
    std::vector<int>* places;  ///< per edge: where it is in the heap, or -1

    bool less(const Candidate& a, const Candidate& b) const {
      return std::tie(a.cost, a.edge) < std::tie(b.cost, b.edge);
    }
    bool greater(const Candidate& a, const Candidate& b) const { return less(b, a); }
    int get_heap_position(const Candidate& c) const { return (*places)[c.edge]; }
    void set_heap_position(const Candidate& c, int place) { (*places)[c.edge] = place; }
  };

  std::vector<int> places_;
  OpenMesh::Utils::HeapT<Candidate, Order> heap_;
};

/// What comes of a collapse.
struct Outcome {
  Vec3 place;
  double cost;
};

double square(double x) { return x * x; }

double area_of(const Mesh& mesh) {
  double area = 0;
  for (int f = 0; f < mesh.face_count(); ++f) area += face_area(mesh, f);
  return area;
}

class EdgeCollapse {
 public:
  EdgeCollapse(const Mesh& mesh, const CollapseOptions& options)
      : options_(options),
        positions_(mesh.positions),
        quadrics_(surface_quadrics(mesh, options.regions, options.plane)),
        face_count_(mesh.face_count()) {
    if (options_.plane) is_on_ = options_.plane->is_on;
    build(mesh);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : positions_) box.extend(p);
    extent_ = box.diagonal().norm();
    // Of equilateral triangles with the surface's area.
    edge_of_one_face_ = std::sqrt(4 / std::sqrt(3) * area_of(mesh));
    queue_.emplace(connectivity_.n_edges());
    is_refused_.assign(connectivity_.n_edges(), false);
  }

  void run() {
    for (const EdgeHandle edge : connectivity_.edges()) offer(edge);
    while (face_count_ > options_.target_faces && !queue_->empty()) take_next();
  }

  CollapsedMesh result() const {
    CollapsedMesh mesh;
    std::vector<int> numbers(positions_.size(), -1);
    for (const auto vertex : connectivity_.vertices()) {
      if (vertex.deleted() || connectivity_.is_isolated(vertex)) continue;
      numbers[vertex.idx()] = static_cast<int>(mesh.positions.size());
      mesh.positions.push_back(positions_[vertex.idx()]);
      if (options_.plane) mesh.is_on_plane.push_back(is_on_[vertex.idx()]);
    }
    for (const auto face : connectivity_.faces()) {
      if (face.deleted()) continue;
      FaceVertices vertices = vertices_of(face);
      for (int& v : vertices) v = numbers[v];
      mesh.faces.push_back(vertices);
    }
    return mesh;
  }

 private:
  void build(const Mesh& mesh) {
    connectivity_.reserve(mesh.positions.size(), mesh.edges.size(), mesh.faces.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) connectivity_.add_vertex();
    for (const auto& [a, b, c] : mesh.faces) {
      connectivity_.add_face(VertexHandle(a), VertexHandle(b), VertexHandle(c));
    }
    connectivity_.request_vertex_status();
    connectivity_.request_edge_status();
    connectivity_.request_halfedge_status();
    connectivity_.request_face_status();
  }

  bool is_on(int vertex) const { return options_.plane && is_on_[vertex]; }

  Triangle3 corners_of_vertices(const FaceVertices& vertices) const {
    return {positions_[vertices[0]], positions_[vertices[1]], positions_[vertices[2]]};
  }

  FaceVertices vertices_of(Connectivity::FaceHandle face) const {
    FaceVertices vertices;
    int corner = 0;
    for (const auto v : connectivity_.fv_range(face)) vertices[corner++] = v.idx();
    return vertices;
  }

  /// Puts an edge into the queue, by its quadric error alone: most edges change before it is their
  /// turn, and looking at the faces around them takes several times as long.
  void offer(EdgeHandle edge) {
    const auto [from, to] = ends_of(edge);
    const Quadric quadric = joined_quadric(from, to);
    is_refused_[edge.idx()] = false;
    queue_->put({quadric.at(best_place(quadric, from, to)), edge.idx()});
  }

  /// Offers the edges at a vertex that a collapse has changed, and those around it that were not
  /// allowed before and may be now.
  void offer_around(VertexHandle vertex) {
    std::vector<EdgeHandle> changed;
    for (const auto edge : connectivity_.ve_range(vertex)) changed.push_back(edge);
    for (const auto neighbour : connectivity_.vv_range(vertex)) {
      for (const auto edge : connectivity_.ve_range(neighbour)) {
        const bool is_own = edge.v0() == vertex || edge.v1() == vertex;
        if (is_refused_[edge.idx()] && !is_own) changed.push_back(edge);
      }
    }
    for (const EdgeHandle edge : changed) offer(edge);
  }

  void take_next() {
    const Candidate next = queue_->first();
    queue_->drop_first();
    const EdgeHandle edge(next.edge);
    if (connectivity_.status(edge).deleted()) return;
    // What the shapes of its faces cost counts only now, and they may have changed meanwhile.
    const auto outcome = evaluate(edge);
    is_refused_[next.edge] = true;
    if (!outcome) return;
    if (outcome->cost > next.cost && !queue_->empty() && outcome->cost > queue_->first().cost) {
      is_refused_[next.edge] = false;
      queue_->put({outcome->cost, next.edge});
      return;
    }
    const HalfedgeHandle halfedge = connectivity_.halfedge_handle(edge, 0);
    if (!connectivity_.is_collapse_ok(halfedge) || !keeps_valence(edge)) return;
    if (is_guarded() && runs_through_more(edge, outcome->place)) return;
    collapse(halfedge, outcome->place);
  }

  /// The best place for the vertex that an edge becomes; none if it must not be collapsed.
  std::optional<Outcome> evaluate(EdgeHandle edge) {
    const auto [from, to] = ends_of(edge);
    if (!keeps_plane(from, to) || !keeps_plane(to, from)) return std::nullopt;
    gather_fan(from, to);
    const Quadric quadric = joined_quadric(from, to);
    const double nothing = kNothing * square((positions_[from] - positions_[to]).squaredNorm());
    std::optional<Outcome> best;
    const auto look_at = [&](const Vec3& place) {
      if (!is_on_right_side(place, from, to)) return;
      const auto shapes = shape_change(place);
      if (!shapes) return;
      const double error = quadric.at(place);
      const double cost = error + (error <= nothing ? kFlatShapes : 1) * *shapes;
      if (!best || cost < best->cost) best = {place, cost};
    };
    look_at(best_place(quadric, from, to));
    if (best) return best;
    look_at(start_place(from, to));
    const bool on_plane = is_on(from) || is_on(to);
    if (is_on(from) == on_plane) look_at(positions_[from]);
    if (is_on(to) == on_plane) look_at(positions_[to]);
    return best;
  }

  std::array<int, 2> ends_of(EdgeHandle edge) const {
    const HalfedgeHandle halfedge = connectivity_.halfedge_handle(edge, 0);
    return {connectivity_.from_vertex_handle(halfedge).idx(),
            connectivity_.to_vertex_handle(halfedge).idx()};
  }

  Quadric joined_quadric(int from, int to) const {
    Quadric quadric = quadrics_[from];
    quadric += quadrics_[to];
    return quadric;
  }

  /// Where the quadric error is least; the start when that is far away.
  Vec3 best_place(const Quadric& quadric, int from, int to) const {
    const Vec3 start = start_place(from, to);
    const bool on_plane = is_on(from) || is_on(to);
    const Vec3 place = quadric.least_near(start, on_plane ? &options_.plane->normal : nullptr);
    const double length = (positions_[from] - positions_[to]).norm();
    return (place - start).norm() <= kFurthest * length ? place : start;
  }

  /// The middle of an edge, or the vertex of it that lies on the plane.
  Vec3 start_place(int from, int to) const {
    if (is_on(from) != is_on(to)) return positions_[is_on(from) ? from : to];
    return 0.5 * (positions_[from] + positions_[to]);
  }

  bool is_on_right_side(const Vec3& place, int from, int to) const {
    if (!options_.plane || is_on(from) || is_on(to)) return true;
    const double height = options_.plane->normal.dot(place) - options_.plane->offset;
    return height >= kOffPlane * (positions_[from] - positions_[to]).norm();
  }

  /// Whether no edge but one on the border comes to join two vertices on the plane: it would be one
  /// with its own image, and have four faces.
  bool keeps_plane(int moved, int kept) const {
    if (!is_on(kept)) return true;
    if (is_on(moved)) return true;  // both are on the border: the connectivity decides
    for (const auto edge : connectivity_.ve_range(VertexHandle(moved))) {
      const int other = edge.v0().idx() == moved ? edge.v1().idx() : edge.v0().idx();
      if (other == kept || !is_on(other)) continue;
      const auto beside = connectivity_.find_halfedge(VertexHandle(kept), VertexHandle(other));
      if (!beside.is_valid() || !connectivity_.is_boundary(beside.edge())) return false;
    }
    return true;
  }

  /// Whether no vertex is left with two edges alone, which would be two faces on each other.
  bool keeps_valence(EdgeHandle edge) const {
    for (const int side : {0, 1}) {
      const HalfedgeHandle halfedge = connectivity_.halfedge_handle(edge, side);
      if (connectivity_.is_boundary(halfedge)) continue;
      const VertexHandle opposite =
          connectivity_.to_vertex_handle(connectivity_.next_halfedge_handle(halfedge));
      if (connectivity_.valence(opposite) <= 3 && !connectivity_.is_boundary(opposite)) {
        return false;
      }
    }
    return true;
  }

  /// The faces around an edge: `fan_` are those that stay, `removed_` those that go.
  void gather_fan(int from, int to) {
    fan_.clear();
    removed_.clear();
    for (const int vertex : {from, to}) {
      const int other = vertex == from ? to : from;
      for (const auto face : connectivity_.vf_range(VertexHandle(vertex))) {
        const FaceVertices vertices = vertices_of(face);
        const int corner = static_cast<int>(std::ranges::find(vertices, vertex) - vertices.begin());
        if (std::ranges::count(vertices, other) == 0) {
          fan_.push_back({face.idx(), corner, vertices});
        } else if (vertex == from) {
          removed_.push_back({face.idx(), corner, vertices});
        }
      }
    }
  }

  /// By how much the shapes of the faces around an edge cost more than before once it is a vertex
  /// here; none if one of them would turn over. \pre the fan is gathered
  std::optional<double> shape_change(const Vec3& place) const {
    const double usual = usual_edge();
    double change = 0;
    for (const FanFace& face : fan_) {
      const Triangle3 before = corners_of_vertices(face.vertices);
      Triangle3 after = before;
      after[face.corner] = place;
      if (!keeps_facing(before, after)) return std::nullopt;
      change += shape_cost(after, usual) - shape_cost(before, usual);
    }
    for (const FanFace& face : removed_) {
      change -= shape_cost(corners_of_vertices(face.vertices), usual);
    }
    return change;
  }

  /// Length of the edges that a mesh with as many faces as there are now has.
  double usual_edge() const { return edge_of_one_face_ / std::sqrt(face_count_); }

  bool is_guarded() {
    if (!options_.keep_apart || face_count_ > kGuardedFaces) return false;
    // Cells fit the edges that there are when the guard is made.
    if (!guard_ || 2 * face_count_ < guarded_since_) make_guard();
    return true;
  }

  void make_guard() {
    double length = 0;
    for (const auto edge : connectivity_.edges()) {
      if (!edge.deleted())
        length += (positions_[edge.v0().idx()] - positions_[edge.v1().idx()]).norm();
    }
    guarded_since_ = face_count_;
    guard_.emplace(static_cast<int>(connectivity_.n_faces()), length / (1.5 * face_count_),
                   extent_);
    for (const auto face : connectivity_.faces()) {
      if (face.deleted()) continue;
      const FaceVertices vertices = vertices_of(face);
      guard_->set(face.idx(), vertices, corners_of_vertices(vertices));
    }
  }

  /// Whether the faces around an edge would run through more faces than they do. \pre guarded, and
  /// the edge was evaluated last
  bool runs_through_more(EdgeHandle edge, const Vec3& place) {
    const int kept = connectivity_.to_vertex_handle(connectivity_.halfedge_handle(edge, 0)).idx();
    std::vector<int> around;
    for (const FanFace& face : fan_) around.push_back(face.index);
    for (const FanFace& face : removed_) around.push_back(face.index);
    int after = 0;
    for (const FanFace& face : fan_) {
      FaceVertices vertices = face.vertices;
      Triangle3 corners = corners_of_vertices(vertices);
      vertices[face.corner] = kept;
      corners[face.corner] = place;
      after += guard_->crossings(vertices, corners, around);
    }
    if (after == 0) return false;
    int before = 0;
    for (const auto* faces : {&fan_, &removed_}) {
      for (const FanFace& face : *faces) {
        before += guard_->crossings(face.vertices, corners_of_vertices(face.vertices), around);
      }
    }
    return after > before;
  }

  /// \pre the edge was evaluated last
  void collapse(HalfedgeHandle halfedge, const Vec3& place) {
    const int removed = connectivity_.from_vertex_handle(halfedge).idx();
    const VertexHandle kept = connectivity_.to_vertex_handle(halfedge);
    connectivity_.collapse(halfedge);
    positions_[kept.idx()] = place;
    quadrics_[kept.idx()] += quadrics_[removed];
    if (options_.plane) is_on_[kept.idx()] = is_on_[kept.idx()] || is_on_[removed];
    face_count_ -= static_cast<int>(removed_.size());
    if (guard_) {
      for (const FanFace& face : removed_) guard_->remove(face.index);
      for (const FanFace& face : fan_) {
        const FaceVertices vertices = vertices_of(Connectivity::FaceHandle(face.index));
        guard_->set(face.index, vertices, corners_of_vertices(vertices));
      }
    }
    offer_around(kept);
  }

  struct FanFace {
    int index;
    int corner;  ///< which moves
    FaceVertices vertices;
  };

  const CollapseOptions& options_;
  Connectivity connectivity_;
  std::vector<Vec3> positions_;
  std::vector<Quadric> quadrics_;
  std::vector<bool> is_on_;
  std::vector<bool> is_refused_;  ///< per edge: it was not allowed when last looked at
  std::optional<EdgeQueue> queue_;
  std::vector<FanFace> fan_, removed_;
  std::optional<CrossingGuard> guard_;
  int guarded_since_ = 0;
  double extent_ = 0;
  double edge_of_one_face_ = 0;
  int face_count_;
};

}  // namespace

CollapsedMesh collapse_edges(const Mesh& mesh, const CollapseOptions& options) {
  EdgeCollapse collapse(mesh, options);
  collapse.run();
  return collapse.result();
}

}  // namespace foldwright
