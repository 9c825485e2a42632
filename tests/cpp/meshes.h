#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/triangle3.h"
#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

/// Small meshes with known properties, shared by the tests. All closed ones are wound outwards.
namespace foldwright::testing {

/// Unit cube around the origin: 8 vertices, 12 triangles.
Mesh cube();

/// Regular tetrahedron inscribed in the cube of side 2.
Mesh tetrahedron();

/// Regular icosahedron with unit circumradius: 20 triangles.
Mesh icosahedron();

/// Icosahedron with a spike on every face: closed, non-convex, 60 triangles.
Mesh star();

/// Torus with radii 1 and 0.4: `around` x `tube` quads, each in two triangles. \pre both >= 3
Mesh torus(int around, int tube);

/// Uneven block of 5 x 3 with two holes: closed, of genus 2, 100 triangles.
Mesh pretzel();

/// Flat open strip of `squares` unit squares in a row: 2 * squares triangles.
Mesh open_strip(int squares);

/// Flat open sheet of `side` x `side` unit squares, each in two triangles.
Mesh open_sheet(int side);

/// Square with a front and a back that share all four edges: closed, without volume.
Mesh two_sided_square();

/// Open strip of rectangles of height 1, folded up and down by right angles: one panel each.
Mesh accordion(const std::vector<double>& widths);

/// Open strip of five panels, of which the first and the last run through each other.
Mesh crossing_strip();

/// Open fan of `faces` equal triangles around vertex 0 whose angles there sum up to `turn`. With
/// more than a full turn no net of it exists. \pre faces is even, turn > 2 pi
Mesh saddle(int faces, double turn);

/// A saddle of 8 faces, and an apron of quads along its rim: the saddle's faces come first.
/// \pre 1 <= quads <= 7, turn > 2 pi
Mesh saddle_with_apron(double turn, int quads);

/// Two unit spheres joined by a thin neck, with so many points around: closed, 28 triangles each.
Mesh dumbbell(int around = 12);

/// Sphere with gentle hills, about `faces` triangles: closed, not convex. \pre faces >= 24
Mesh bumpy_sphere(int faces);

/// Sphere with higher hills, symmetric about x = 0 alone; its triangles are not. \pre faces >= 24
Mesh bilateral(int faces);

/// Moebius strip of `quads` quads: non-orientable, so only `repair` makes a Mesh of it. \pre >= 3
PolygonSoup mobius_strip(int quads);

/// Convex hull of `points` random points on the unit sphere; same seed, same hull. \pre points >= 4
Mesh random_hull(std::uint64_t seed, int points);

/// Polygons over the given positions, as a reader would deliver them.
PolygonSoup soup(std::vector<Vec3> positions, const std::vector<std::vector<int>>& polygons);

/// The faces of a mesh as polygons, to be spoilt by a test and repaired.
PolygonSoup soup_of(const Mesh& mesh);

/// A mesh as an OBJ file, with all digits of its coordinates.
std::string obj_of(const Mesh& mesh);

/// Volume enclosed by a closed component, positive when it is wound outwards.
double signed_volume(const Mesh& mesh, int component = 0);

/// Area of all faces.
double area_of(const Mesh& mesh);

/// The smallest angle of a triangle, in degrees.
double sharpest_corner(const Triangle3& t);

/// Number of edges with one face.
int border_edge_count(const Mesh& mesh);

}  // namespace foldwright::testing
