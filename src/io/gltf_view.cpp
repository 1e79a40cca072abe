#include "io/gltf_view.h"
#include "base/error.h"
#include <fmt/format.h>
#include <numbers>

namespace nacre::io {

namespace {

Json to_json(const Vec3 &v) { return {v.x(), v.y(), v.z()}; }

// glTF's cameras and lights look along -z.
Vec3 forward_of(const GltfNode &node) { return -node.to_world.linear().col(2).stableNormalized(); }

Json camera_of(const GltfFile &file, const GltfNode &node, int index, const scene::Bounds &box) {
    if (static_cast<std::size_t>(index) >= file.model.cameras.size())
        input_error(file.subject, "nodes.{}: there is no camera {}", node.index, index);
    const tinygltf::Camera &camera = file.model.cameras[index];
    const Vec3 position = node.to_world.translation(), forward = forward_of(node);
    // glTF has no point of interest; the depth of the objects' middle keeps focus useful when an aperture is set.
    const double depth = (box.center() - position).dot(forward);
    Json tree = Json::object();
    tree["type"] = camera.type;
    if (camera.type == "orthographic")
        tree["height"] = 2 * camera.orthographic.ymag;
    else
        tree["fov"] = camera.perspective.yfov * 180 / std::numbers::pi;
    tree["position"] = to_json(position);
    tree["target"] = to_json(position + (depth > 0 ? depth : box.diagonal().norm()) * forward);
    tree["up"] = to_json(node.to_world.linear().col(1).stableNormalized());
    return tree;
}

} // namespace

Json read_gltf_camera(const GltfFile &file, const std::vector<GltfNode> &nodes, const scene::Bounds &box,
                      std::vector<std::string> &warnings) {
    Json first;
    int count = 0;
    for (const GltfNode &node : nodes) {
        const int index = file.model.nodes[node.index].camera;
        if (index >= 0 && count++ == 0) first = camera_of(file, node, index, box);
    }
    if (count > 1) warnings.push_back(fmt::format("{}: the first of {} cameras is used", file.subject, count));
    return first;
}

Json read_gltf_lights(const GltfFile &file, const std::vector<GltfNode> &nodes, std::vector<std::string> &warnings) {
    constexpr const char *name = "KHR_lights_punctual";
    const auto extension = [&](const Json &holder) {
        const Json *extensions = gltf_member(holder, "extensions");
        return extensions ? gltf_member(*extensions, name) : nullptr;
    };
    Json lights = Json::array();
    for (const GltfNode &node : nodes) {
        const std::string where = fmt::format("{}: nodes.{}", file.subject, node.index);
        const Json *reference = extension(gltf_element(file, "nodes", node.index));
        if (!reference) continue;
        const Json *all = extension(file.json);
        const Json *list = all ? gltf_member(*all, "lights") : nullptr;
        const int index = gltf_index(*reference, "light", where);
        if (!list || !list->is_array() || index < 0 || static_cast<std::size_t>(index) >= list->size())
            input_error(where, "there is no light {}", index);
        const Json &light = (*list)[index];
        const Json *type = gltf_member(light, "type");
        const Vec3 strength =
            gltf_number(light, "intensity", 1, where) * gltf_color(light, "color", Vec3::Ones(), where);
        if (type && *type == "directional") {
            lights.push_back(
                {{"type", "directional"}, {"direction", to_json(forward_of(node))}, {"irradiance", to_json(strength)}});
            continue;
        }
        if (type && *type == "spot") warnings.push_back(where + ": a spot light is drawn as a point light");
        lights.push_back(
            {{"type", "point"}, {"position", to_json(node.to_world.translation())}, {"intensity", to_json(strength)}});
    }
    return lights;
}

} // namespace nacre::io
