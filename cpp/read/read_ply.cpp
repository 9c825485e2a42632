#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "mesh/input_error.h"
#include "read/byte_reader.h"
#include "read/formats.h"
#include "read/ply_header.h"
#include "read/soup_builder.h"
#include "read/text_encoding.h"

namespace foldwright {
namespace {

/// The values after the header, one by one, whatever their encoding.
class PlyData {
 public:
  PlyData(const TextScanner& scanner, std::span<const std::byte> bytes, PlyEncoding encoding)
      : is_ascii_(encoding == PlyEncoding::kAscii),
        scanner_(scanner),
        reader_(bytes.subspan(scanner.position()),
                encoding == PlyEncoding::kBigEndian ? std::endian::big : std::endian::little) {}

  double value(PlyType type) {
    if (is_ascii_) return scanner_.number();
    if (reader_.left() < static_cast<std::size_t>(size_of(type))) fail_at_end();
    switch (type) {
      case PlyType::kInt8:
        return reader_.read<std::int8_t>();
      case PlyType::kUint8:
        return reader_.read<std::uint8_t>();
      case PlyType::kInt16:
        return reader_.read<std::int16_t>();
      case PlyType::kUint16:
        return reader_.read<std::uint16_t>();
      case PlyType::kInt32:
        return reader_.read<std::int32_t>();
      case PlyType::kUint32:
        return reader_.read<std::uint32_t>();
      case PlyType::kFloat32:
        return reader_.read<float>();
      case PlyType::kFloat64:
        return reader_.read<double>();
    }
    return 0;
  }

  /// A coordinate, which counts for the precision of the model.
  double coordinate(PlyType type, SoupBuilder& builder) {
    if (is_ascii_) {
      const std::string_view word = scanner_.number_word();
      return builder.text_coordinate(word, scanner_.line());
    }
    const double number = value(type);
    return type == PlyType::kFloat32 ? builder.single_coordinate(number)
                                     : builder.double_coordinate(number);
  }

  /// A list's length or a vertex's index. Floats are not unheard of, and every index is exact in
  /// a double; -1 stands for what is no index at all.
  long long integer(PlyType type) {
    const double number = value(type);
    constexpr double kLargest = 1e15;  // exact, and far beyond any index
    return number == std::floor(number) && std::abs(number) <= kLargest
               ? static_cast<long long>(number)
               : -1;
  }

  /// Tells which element the next values belong to, for messages.
  void begin(const PlyElement& element, long long index) {
    element_ = &element;
    index_ = index;
  }

  /// Where the value read last stands.
  Place place() const {
    if (is_ascii_) return {"line", scanner_.line()};
    return {element_->name == "vertex" ? "vertex"
            : element_->name == "face" ? "face"
                                       : "element",
            index_};
  }

 private:
  bool is_ascii_;
  TextScanner scanner_;
  ByteReader reader_;
  const PlyElement* element_ = nullptr;
  long long index_ = 0;

  [[noreturn]] void fail_at_end() const {
    throw InputError("truncated", place(),
                     {{"what", "element"},
                      {"announced", element_->count},
                      {"element", excerpt(element_->name)}});
  }
};

/// What becomes of a property's values.
enum class Role {
  kX,
  kY,
  kZ,
  kCorners,
  kStrips,
  kRed,
  kGreen,
  kBlue,
  kAcross,  // a vertex's place in a picture
  kUp,
  kCornerPlaces,  // those of all corners of a face
  kMaterial,
  kSkipped
};

bool is_whole(PlyType type) { return type != PlyType::kFloat32 && type != PlyType::kFloat64; }

/// The list with the vertices of a face or strip: by its usual names, else the only list of whole
/// numbers; null when there is none.
const PlyProperty* vertex_list(const PlyElement& element) {
  const PlyProperty* only = nullptr;
  int lists = 0;
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type) continue;
    if (property.name == "vertex_indices" || property.name == "vertex_index") return &property;
    if (!is_whole(property.type)) continue;
    only = &property;
    ++lists;
  }
  return lists == 1 ? only : nullptr;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

/// By the names that programs write.
Role colour_role(std::string_view name) {
  if (is_one_of(name, {"red", "r", "diffuse_red"})) return Role::kRed;
  if (is_one_of(name, {"green", "g", "diffuse_green"})) return Role::kGreen;
  if (is_one_of(name, {"blue", "b", "diffuse_blue"})) return Role::kBlue;
  return Role::kSkipped;
}

Role vertex_role(const PlyProperty& property) {
  const std::string& name = property.name;
  if (property.count_type) return Role::kSkipped;
  if (name == "x") return Role::kX;
  if (name == "y") return Role::kY;
  if (name == "z") return Role::kZ;
  if (is_one_of(name, {"s", "u", "texture_s", "texture_u"})) return Role::kAcross;
  if (is_one_of(name, {"t", "v", "texture_t", "texture_v"})) return Role::kUp;
  return colour_role(name);
}

Role face_role(const PlyElement& element, const PlyProperty& property) {
  if (&property == vertex_list(element)) return Role::kCorners;
  if (property.count_type) {
    return property.name == "texcoord" ? Role::kCornerPlaces : Role::kSkipped;
  }
  const bool is_material = is_one_of(property.name, {"material", "material_index", "texnumber"});
  return is_material ? Role::kMaterial : colour_role(property.name);
}

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex") return vertex_role(property);
  if (element.name == "face") return face_role(element, property);
  if (element.name == "tristrips" && &property == vertex_list(element)) return Role::kStrips;
  return Role::kSkipped;
}

std::vector<Role> roles_of(const PlyElement& element) {
  std::vector<Role> roles;
  for (const PlyProperty& property : element.properties) {
    roles.push_back(role_of(element, property));
  }
  const auto require = [&](Role role, const char* name) {
    if (std::count(roles.begin(), roles.end(), role) == 1) return;
    throw InputError(
        "bad-header",
        {{"what", "property"}, {"element", excerpt(element.name)}, {"property", name}});
  };
  if (element.name == "vertex") {
    require(Role::kX, "x");
    require(Role::kY, "y");
    require(Role::kZ, "z");
  } else if (element.name == "face") {
    require(Role::kCorners, "vertex_indices");
  } else if (element.name == "tristrips") {
    require(Role::kStrips, "vertex_indices");
  }
  return roles;
}

/// Triangles over a list of vertices, of which each makes one with the two before it. Every other
/// one is turned over by that, and turned back here; a number that is no vertex ends a strip.
class TriangleStrips {
 public:
  TriangleStrips(SoupBuilder& builder, const Place& place) : builder_(builder), place_(place) {}

  void add(long long vertex) {
    constexpr long long kMinusOneUnsigned = 0xFFFFFFFF;  // written by programs without signs
    if (vertex < 0 || vertex == kMinusOneUnsigned) {
      length_ = 0;
      return;
    }
    ++length_;
    // Strips are joined by vertices that are given twice: no triangle is meant there.
    if (length_ >= 3 && first_ != second_ && first_ != vertex && second_ != vertex) {
      const bool is_turned = length_ % 2 == 0;
      builder_.add_corner(is_turned ? second_ : first_);
      builder_.add_corner(is_turned ? first_ : second_);
      builder_.add_corner(vertex);
      builder_.end_face(place_);
    }
    first_ = second_;
    second_ = vertex;
  }

 private:
  SoupBuilder& builder_;
  Place place_;
  long long length_ = 0;  // of the strip so far
  long long first_ = 0;   // the two vertices before
  long long second_ = 0;
};

/// What a vertex or a face has beside coordinates and corners.
struct ElementLooks {
  Vec3 colour = Vec3::Zero();
  PicturePlace place = {0, 0};
  int material = -1;

  void take(Role role, double value, PlyType type) {
    switch (role) {
      case Role::kRed:
      case Role::kGreen:
      case Role::kBlue:
        colour[static_cast<int>(role) - static_cast<int>(Role::kRed)] = value / one_of(type);
        return;
      case Role::kAcross:
        place[0] = static_cast<float>(value);
        return;
      case Role::kUp:
        place[1] = static_cast<float>(value);
        return;
      case Role::kMaterial:
        // Beyond any number of materials, and far from what an int cannot hold.
        material = value >= 0 && value < 1e9 ? static_cast<int>(value) : -1;
        return;
      default:
        return;
    }
  }

 private:
  /// What stands for a full colour; of floats the looks' builder finds out.
  static double one_of(PlyType type) {
    if (!is_whole(type)) return 1;
    return size_of(type) == 2 ? 65535 : 255;
  }
};

bool has(const std::vector<Role>& roles, Role role) {
  return std::ranges::find(roles, role) != roles.end();
}

/// Hands over what the element `index` has, as far as its properties say something.
void add_looks(const ElementLooks& found, const std::vector<Role>& roles, bool is_vertex, int index,
               LooksBuilder& looks) {
  const bool has_colour =
      has(roles, Role::kRed) && has(roles, Role::kGreen) && has(roles, Role::kBlue);
  if (is_vertex) {
    if (has_colour) looks.colour_vertex(index, found.colour);
    if (has(roles, Role::kAcross) && has(roles, Role::kUp)) looks.place_vertex(index, found.place);
  } else {
    if (has_colour) looks.colour_face(index, found.colour);
    if (has(roles, Role::kMaterial)) looks.set_material(index, found.material);
  }
}

/// Two numbers for each corner of the face whose corners begin at `first`.
void read_corner_places(PlyData& data, const PlyProperty& property, std::size_t first,
                        LooksBuilder& looks) {
  const long long count = data.integer(*property.count_type);
  PicturePlace place = {0, 0};
  for (long long i = 0; i < count; ++i) {
    place[i % 2] = static_cast<float>(data.value(property.type));
    if (i % 2 == 1) looks.place_corner(first + static_cast<std::size_t>(i / 2), place);
  }
}

void read_list(PlyData& data, const PlyProperty& property, Role role, SoupBuilder& builder) {
  const long long count = data.integer(*property.count_type);
  TriangleStrips strips(builder, data.place());
  for (long long i = 0; i < count; ++i) {
    const long long value = data.integer(property.type);
    if (role == Role::kCorners) builder.add_corner(value);
    if (role == Role::kStrips) strips.add(value);
  }
}

void read_element(PlyData& data, const PlyElement& element, SoupBuilder& builder) {
  if (element.count == 0) return;  // then it may lack properties, too
  const std::vector<Role> roles = roles_of(element);
  // Without properties an element has no bytes, and its count may be anything.
  if (element.properties.empty()) return;
  const bool is_vertex = element.name == "vertex";
  const bool is_face = element.name == "face";
  for (long long index = 0; index < element.count; ++index) {
    data.begin(element, index);
    Vec3 position = Vec3::Zero();
    ElementLooks looks;
    const std::size_t first_corner = builder.ended_corner_count();
    for (std::size_t p = 0; p < roles.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (roles[p] == Role::kCornerPlaces) {
        read_corner_places(data, property, first_corner, builder.looks());
        continue;
      }
      if (property.count_type) {
        read_list(data, property, roles[p], builder);
        continue;
      }
      if (roles[p] <= Role::kZ) {
        position[static_cast<int>(roles[p])] = data.coordinate(property.type, builder);
      } else {
        looks.take(roles[p], data.value(property.type), property.type);
      }
    }
    if (is_vertex) builder.add_vertex(position, data.place());
    if (is_face) builder.end_face(data.place());
    const int number = (is_vertex ? builder.vertex_count() : builder.face_count()) - 1;
    if (is_vertex || is_face) add_looks(looks, roles, is_vertex, number, builder.looks());
  }
}

}  // namespace

PolygonSoup read_ply(std::span<const std::byte> bytes) {
  TextScanner scanner(bytes);
  const PlyHeader header = read_ply_header(scanner);
  const bool is_ascii = header.encoding == PlyEncoding::kAscii;
  refuse_nul(is_ascii ? bytes : bytes.first(scanner.position()));
  PlyData data(scanner, bytes, header.encoding);
  return build_soup(0, [&](SoupBuilder& builder) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "face") builder.announce_faces(element.count);
      read_element(data, element, builder);
    }
  });
}

}  // namespace foldwright
