// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support/small_mesh_files.h"

namespace luxel {

// Contents of the files below, besides the cube of SmallCube: its last face has the material
// "lamp", the others "wall".
struct ConvertedCube {
  Vec3 wall = Vec3(0.2f, 0.4f, 0.6f);      // reflectance
  Vec3 emission = Vec3(2.0f, 1.0f, 0.5f);  // W/(m² sr)
  Vec3 place = Vec3(3.0f, 5.0f, 7.0f);     // of the node, in units of the file
  std::string picture = {};                // of the wall, in place of its colour; DAE and FBX
};

inline std::string numbers_of(const std::vector<Vec3>& vectors, const char* between) {
  std::string text;
  for (const auto& v : vectors)
    text += fmt::format("{}{}{}{}{}{}", text.empty() ? "" : between, v.x, between, v.y, between, v.z);
  return text;
}

// COLLADA. asset: unit and up axis; instances: more nodes of the same geometry, at x = 100, 200, ...
class SmallDae {
 public:
  ConvertedCube cube;
  std::string asset = "<unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis>";
  std::string libraries, nodes;  // of lamps and cameras
  std::string transparency;
  int instances = 1;

  std::string text() const {
    const SmallCube shape;
    std::string scene;
    for (int i = 0; i < instances; ++i)
      scene += node(fmt::format("box {}", i), cube.place + Vec3(100.0f * static_cast<float>(i), 0, 0));
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n<asset>" +
           asset + "</asset>\n" + images() + "<library_effects>\n" + effect("wall", diffuse(), Vec3(0.0f)) +
           effect("lamp", "<color>0 0 0 1</color>", cube.emission) +
           "</library_effects>\n<library_materials>" + material("wall") + material("lamp") +
           "</library_materials>\n" + libraries +
           "<library_geometries><geometry id=\"cube-mesh\" name=\"cube\"><mesh>\n"
           "<source id=\"p\"><float_array id=\"pa\" count=\"24\">" +
           numbers_of(shape.positions, " ") +
           "</float_array><technique_common><accessor source=\"#pa\" count=\"8\" stride=\"3\"><param "
           "name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/>"
           "</accessor></technique_common></source>\n<source id=\"t\"><float_array id=\"ta\" count=\"8\">0 0 "
           "1 0 1 1 "
           "0 1</float_array><technique_common><accessor source=\"#ta\" count=\"4\" stride=\"2\"><param "
           "name=\"S\" type=\"float\"/><param name=\"T\" "
           "type=\"float\"/></accessor></technique_common></source>\n"
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n" +
           polygons("wall", 0, 5) + polygons("lamp", 5, 6) +
           "</mesh></geometry></library_geometries>\n<library_visual_scenes><visual_scene id=\"s\">\n" +
           scene + nodes +
           "</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene "
           "url=\"#s\"/></scene>\n</COLLADA>\n";
  }

 private:
  std::string images() const {
    if (cube.picture.empty()) return {};
    return "<library_images><image id=\"tiles\"><init_from>" + cube.picture +
           "</init_from></image></library_images>\n";
  }
  std::string diffuse() const {
    if (!cube.picture.empty()) return "<texture texture=\"sampler\" texcoord=\"UV\"/>";
    return fmt::format("<color>{} {} {} 1</color>", cube.wall.x, cube.wall.y, cube.wall.z);
  }
  std::string effect(const std::string& name, const std::string& colour, const Vec3& light) const {
    return fmt::format(
        "<effect id=\"{0}-fx\"><profile_COMMON><newparam sid=\"surface\"><surface "
        "type=\"2D\"><init_from>tiles</init_from></surface></newparam><newparam "
        "sid=\"sampler\"><sampler2D><source>surface</source></sampler2D></newparam><technique "
        "sid=\"c\"><lambert><emission><color>{1} {2} {3} "
        "1</color></emission><diffuse>{4}</diffuse>{5}</lambert>"
        "</technique></profile_COMMON></effect>\n",
        name, light.x, light.y, light.z, colour, name == "wall" ? transparency : "");
  }
  static std::string material(const std::string& name) {
    return fmt::format("<material id=\"{0}-id\" name=\"{0}\"><instance_effect url=\"#{0}-fx\"/></material>",
                       name);
  }
  static std::string polygons(const std::string& name, std::size_t begin, std::size_t end) {
    std::string counts, corners;
    for (auto i = begin; i < end; ++i) {
      counts += "4 ";
      for (int corner = 0; corner < 4; ++corner)
        corners += fmt::format("{} {} ", SmallCube().faces[i][static_cast<std::size_t>(corner)], corner);
    }
    return fmt::format(
        "<polylist material=\"{0}\" count=\"{1}\"><input semantic=\"VERTEX\" source=\"#v\" "
        "offset=\"0\"/><input "
        "semantic=\"TEXCOORD\" source=\"#t\" offset=\"1\" "
        "set=\"0\"/><vcount>{2}</vcount><p>{3}</p></polylist>\n",
        name, end - begin, counts, corners);
  }
  static std::string node(const std::string& name, const Vec3& at) {
    const auto bind = [](const char* what) {
      return fmt::format(
          "<instance_material symbol=\"{0}\" target=\"#{0}-id\"><bind_vertex_input semantic=\"UV\" "
          "input_semantic=\"TEXCOORD\" input_set=\"0\"/></instance_material>",
          what);
    };
    return fmt::format(
        "<node id=\"id of {0}\" name=\"{0}\" type=\"NODE\"><translate>{1} {2} "
        "{3}</translate><instance_geometry "
        "url=\"#cube-mesh\"><bind_material><technique_common>{4}{5}</technique_common></bind_material>"
        "</instance_geometry></node>\n",
        name, at.x, at.y, at.z, bind("wall"), bind("lamp"));
  }
};

// FBX 7.3 as text. settings: lines of GlobalSettings; objects and connections: more of them.
class SmallFbx {
 public:
  ConvertedCube cube;
  std::string settings = unit(100.0), objects = {}, connections = {}, wall_properties = {};

  static std::string axis(const char* name, int number, int sign) {
    return fmt::format(
        "P: \"{0}Axis\", \"int\", \"Integer\", \"\",{1}\nP: \"{0}AxisSign\", \"int\", \"Integer\", "
        "\"\",{2}\n",
        name, number, sign);
  }
  static std::string z_up() { return axis("Up", 2, 1) + axis("Front", 1, -1) + axis("Coord", 0, 1); }
  static std::string unit(double centimetres) {
    return fmt::format("P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",{}\n", centimetres);
  }

  std::string text() const {
    const SmallCube shape;
    std::string corners, texture, texture_links;
    for (const auto& [a, b, c, d] : shape.faces)
      corners += fmt::format("{}{},{},{},{}", corners.empty() ? "" : ",", a, b, c, -1 - static_cast<int>(d));
    if (!cube.picture.empty()) {
      texture = "Texture: 400, \"Texture::tiles\", \"\" {\nFileName: \"" + cube.picture +
                "\"\nRelativeFilename: \"" + cube.picture + "\"\n}\n";
      texture_links = "C: \"OP\",400,300, \"DiffuseColor\"\n";
    }
    return "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: 7300\n}\n"
           "GlobalSettings:  {\nVersion: 1000\nProperties70:  {\n" +
           settings +
           "}\n}\nObjects:  {\nGeometry: 100, \"Geometry::cube\", \"Mesh\" {\nVertices: *24 {\na: " +
           numbers_of(shape.positions, ",") + "\n}\nPolygonVertexIndex: *24 {\na: " + corners +
           "\n}\nLayerElementUV: 0 {\nVersion: 101\nName: \"UVMap\"\nMappingInformationType: "
           "\"ByPolygonVertex\"\nReferenceInformationType: \"IndexToDirect\"\nUV: *8 {\na: "
           "0,0,1,0,1,1,0,1\n}\nUVIndex: "
           "*24 {\na: 0,1,2,3,0,1,2,3,0,1,2,3,0,1,2,3,0,1,2,3,0,1,2,3\n}\n}\nLayerElementMaterial: 0 "
           "{\nVersion: "
           "101\nName: \"\"\nMappingInformationType: \"ByPolygon\"\nReferenceInformationType: "
           "\"IndexToDirect\"\nMaterials: *6 {\na: 0,0,0,0,0,1\n}\n}\nLayer: 0 {\nVersion: "
           "100\nLayerElement:  "
           "{\nType: \"LayerElementUV\"\nTypedIndex: 0\n}\nLayerElement:  {\nType: "
           "\"LayerElementMaterial\"\nTypedIndex: 0\n}\n}\n}\nModel: 200, \"Model::box\", \"Mesh\" "
           "{\nVersion: "
           "232\nProperties70:  {\nP: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\"," +
           numbers_of({cube.place}, ",") + "\n}\n}\n" +
           material(300, "wall", color("DiffuseColor", cube.wall) + wall_properties) +
           material(301, "lamp",
                    color("DiffuseColor", Vec3(0.0f)) + color("EmissiveColor", cube.emission / 4.0f) +
                        "P: \"EmissiveFactor\", \"Number\", \"\", \"A\",4\n") +
           texture + objects +
           "}\nConnections:  {\nC: \"OO\",200,0\nC: \"OO\",100,200\nC: \"OO\",300,200\nC: "
           "\"OO\",301,200\n" +
           texture_links + connections + "}\n";
  }

 private:
  static std::string color(const char* name, const Vec3& value) {
    return fmt::format("P: \"{}\", \"Color\", \"\", \"A\",{},{},{}\n", name, value.x, value.y, value.z);
  }
  static std::string material(int number, const char* name, const std::string& properties) {
    return fmt::format(
        "Material: {}, \"Material::{}\", \"\" {{\nVersion: 102\nShadingModel: \"lambert\"\nMultiLayer: "
        "0\nProperties70:  {{\n{}}}\n}}\n",
        number, name, properties);
  }
};

// 3DS, binary. It has no nodes: the cube stands at its place. Emission is a percentage of the colour.
class Small3ds {
 public:
  ConvertedCube cube;
  std::string objects;  // more of them, as chunks

  static std::string chunk(int number, const std::string& contents) {
    return bytes(static_cast<std::uint16_t>(number)) +
           bytes(static_cast<std::uint32_t>(contents.size() + 6)) + contents;
  }
  static std::string text(const std::string& name) { return name + std::string(1, '\0'); }
  template <typename T>
  static std::string bytes(T value) {
    return {reinterpret_cast<const char*>(&value), sizeof(value)};
  }
  static std::string vector(const Vec3& v) { return bytes(v.x) + bytes(v.y) + bytes(v.z); }

  std::string file() const {
    const SmallCube shape;
    const auto triangles = shape.triangles();
    auto points = bytes(static_cast<std::uint16_t>(shape.positions.size()));
    for (const auto& p : shape.positions) points += vector(p + cube.place);
    auto faces = bytes(static_cast<std::uint16_t>(triangles.size()));
    for (const auto& triangle : triangles) {
      for (const auto corner : triangle) faces += bytes(static_cast<std::uint16_t>(corner));
      faces += bytes(std::uint16_t{0});
    }
    const auto mesh =
        chunk(0x4110, points) + chunk(0x4120, faces + group("wall", 0, 10) + group("lamp", 10, 12));
    const auto wall = material("wall", cube.wall, 0), lamp = material("lamp", Vec3(0.8f, 0.4f, 0.2f), 100);
    return chunk(0x4D4D,
                 chunk(0x0002, bytes(std::uint32_t{3})) +
                     chunk(0x3D3D, wall + lamp + chunk(0x4000, text("box") + chunk(0x4100, mesh)) + objects));
  }

 private:
  static std::string material(const std::string& name, const Vec3& colour, int percent) {
    return chunk(0xAFFF, chunk(0xA000, text(name)) + chunk(0xA020, chunk(0x0010, vector(colour))) +
                             chunk(0xA084, chunk(0x0030, bytes(static_cast<std::uint16_t>(percent)))));
  }
  static std::string group(const std::string& name, int begin, int end) {
    auto contents = text(name) + bytes(static_cast<std::uint16_t>(end - begin));
    for (int i = begin; i < end; ++i) contents += bytes(static_cast<std::uint16_t>(i));
    return chunk(0x4130, contents);
  }
};

}  // namespace luxel
