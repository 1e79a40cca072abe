#include "io/gltf_nodes.h"
#include "base/error.h"

namespace nacre::io {

namespace {

Transform local_transform(const tinygltf::Node &node, const std::string &where) {
    Transform transform = Transform::Identity();
    const auto length = [&](const std::vector<double> &values, std::size_t expected, const char *name) {
        if (!values.empty() && values.size() != expected)
            input_error(where, "{} has {} numbers, not {}", name, values.size(), expected);
        return !values.empty();
    };
    if (length(node.matrix, 16, "matrix")) {
        const Eigen::Map<const Eigen::Matrix4d> matrix(node.matrix.data()); // both are column-major
        transform.affine() = matrix.topRows<3>();
        return transform;
    }
    if (length(node.translation, 3, "translation"))
        transform.translate(Vec3(node.translation[0], node.translation[1], node.translation[2]));
    if (length(node.rotation, 4, "rotation")) {
        Eigen::Quaterniond rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (!(rotation.norm() > 0)) input_error(where, "rotation has no length");
        transform.rotate(rotation.normalized());
    }
    if (length(node.scale, 3, "scale")) transform.scale(Vec3(node.scale[0], node.scale[1], node.scale[2]));
    return transform;
}

std::vector<int> root_nodes(const GltfFile &file) {
    const tinygltf::Model &model = file.model;
    if (!model.scenes.empty()) {
        const int active = model.defaultScene < 0 ? 0 : model.defaultScene;
        if (static_cast<std::size_t>(active) >= model.scenes.size())
            input_error(file.subject, "scene: there is no scene {}", active);
        return model.scenes[active].nodes;
    }
    std::vector<bool> is_child(model.nodes.size());
    for (const tinygltf::Node &node : model.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) is_child[child] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

} // namespace

std::vector<GltfNode> place_nodes(const GltfFile &file) {
    const std::vector<tinygltf::Node> &nodes = file.model.nodes;
    std::vector<GltfNode> placed;
    std::vector<bool> seen(nodes.size());
    const auto place = [&](int index, const Transform &parent) {
        if (index < 0 || static_cast<std::size_t>(index) >= nodes.size())
            input_error(file.subject, "nodes: there is no node {}", index);
        if (seen[index]) input_error(file.subject, "nodes.{}: has two parents, or is its own ancestor", index);
        seen[index] = true;
        placed.push_back(
            {index, parent * local_transform(nodes[index], fmt::format("{}: nodes.{}", file.subject, index))});
    };
    for (const int root : root_nodes(file)) place(root, Transform::Identity());
    // Breadth first, so that a long chain of nodes costs no stack.
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const GltfNode parent = placed[i]; // a copy: place() may move the elements
        for (const int child : nodes[parent.index].children) place(child, parent.to_world);
    }
    return placed;
}

} // namespace nacre::io
