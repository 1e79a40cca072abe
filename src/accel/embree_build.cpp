#include "accel/binary_tree.h"
#include "base/error.h"
#include "base/parallel.h"
#include <embree3/rtcore.h>
#include <memory>
#include <type_traits>

namespace nacre::accel {
namespace {

template <auto release> struct Releaser {
    template <typename T> void operator()(T *handle) const { release(handle); }
};
using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<rtcReleaseDevice>>;
using TreeHandle = std::unique_ptr<std::remove_pointer_t<RTCBVH>, Releaser<rtcReleaseBVH>>;

/// What the callbacks make of the tree, in Embree's own memory. A leaf is made without the part that only nodes need.
struct Item {
    Item *child[2];  // null in a leaf
    unsigned number; // a leaf's primitive, or the count of leaves below a node
};
struct Node : Item {
    RTCBounds bounds[2]; // of the children
};
unsigned leaves(const Item &item) { return item.child[0] ? item.number : 1; }

void *create_node(RTCThreadLocalAllocator allocator, unsigned, void *) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node{};
}

void *create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive *primitives, std::size_t, void *) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(Item), 16)) Item{{nullptr, nullptr}, primitives[0].primID};
}

void set_children(void *node, void **children, unsigned count, void *) {
    // Embree has finished the children by then.
    for (unsigned i = 0; i < count; i++) {
        static_cast<Node *>(node)->child[i] = static_cast<Item *>(children[i]);
        static_cast<Node *>(node)->number += leaves(*static_cast<Item *>(children[i]));
    }
}

void set_bounds(void *node, const RTCBounds **bounds, unsigned count, void *) {
    for (unsigned i = 0; i < count; i++) static_cast<Node *>(node)->bounds[i] = *bounds[i];
}

Eigen::AlignedBox3f box(const RTCBounds &b) {
    return {Vec3f(b.lower_x, b.lower_y, b.lower_z), Vec3f(b.upper_x, b.upper_y, b.upper_z)};
}

std::vector<RTCBuildPrimitive> primitives_of(std::span<const Triangle> triangles) {
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); i++) {
        const auto &v = triangles[i].v;
        if (!can_be_hit(triangles[i])) continue;
        const Vec3f lower = v[0].cwiseMin(v[1]).cwiseMin(v[2]), upper = v[0].cwiseMax(v[1]).cwiseMax(v[2]);
        primitives.push_back(
            {lower.x(), lower.y(), lower.z(), 0, upper.x(), upper.y(), upper.z(), static_cast<unsigned>(i)});
    }
    return primitives;
}

/// A subtree, and where it goes.
struct Pending {
    const Item *item;
    std::uint32_t index;
    Eigen::AlignedBox3f bounds;
};

/// Copies the topmost node of a subtree; what is below goes on the stack.
void copy_node(const Pending &from, std::vector<BinaryNode> &nodes, std::vector<Pending> &stack) {
    BinaryNode &node = nodes[from.index];
    node.bounds = from.bounds;
    node.count = leaves(*from.item);
    if (!from.item->child[0]) {
        node.triangle = from.item->number;
        return;
    }
    const auto &built = static_cast<const Node &>(*from.item);
    node.child[0] = from.index + 1;
    node.child[1] = from.index + 2 * leaves(*built.child[0]);
    for (int side = 1; side >= 0; side--)
        stack.push_back({built.child[side], node.child[side], box(built.bounds[side])});
}

/// With a stack of its own, as nothing but Embree's depth limit bounds the tree's depth.
std::vector<BinaryNode> copy_out(const Item *root, const Eigen::AlignedBox3f &root_bounds) {
    std::vector<BinaryNode> nodes(2 * std::size_t(leaves(*root)) - 1);
    std::vector<Pending> stack{{root, 0, root_bounds}}, subtrees;
    while (!stack.empty()) {
        const Pending next = stack.back();
        stack.pop_back();
        if (leaves(*next.item) <= subtree_grain)
            subtrees.push_back(next);
        else
            copy_node(next, nodes, stack);
    }
    parallel_for(subtrees.size(), [&](std::size_t i) {
        std::vector<Pending> below{subtrees[i]};
        while (!below.empty()) {
            const Pending next = below.back();
            below.pop_back();
            copy_node(next, nodes, below);
        }
    });
    return nodes;
}

} // namespace

bool can_be_hit(const Triangle &triangle) {
    const auto &v = triangle.v;
    if (!v[0].allFinite() || !v[1].allFinite() || !v[2].allFinite()) return false;
    // Rounding lets a ray hit a triangle without area, and then it has no normal.
    return !(v[1] - v[0]).cross(v[2] - v[0]).isZero(0);
}

std::vector<BinaryNode> build_binary_tree(std::span<const Triangle> triangles) {
    std::vector<RTCBuildPrimitive> primitives = primitives_of(triangles);
    if (primitives.empty()) return {};
    Eigen::AlignedBox3f bounds;
    for (const auto &p : primitives)
        bounds.extend(Vec3f(p.lower_x, p.lower_y, p.lower_z)).extend(Vec3f(p.upper_x, p.upper_y, p.upper_z));

    const DeviceHandle device(rtcNewDevice(nullptr)); // all cores
    if (!device)
        throw Error(Exit::failed, "BVH",
                    fmt::format("Embree gives no device (error {})", int(rtcGetDeviceError(nullptr))));
    std::string message;
    rtcSetDeviceErrorFunction(
        device.get(), [](void *text, RTCError, const char *what) { *static_cast<std::string *>(text) = what; },
        &message);
    const TreeHandle tree(rtcNewBVH(device.get()));

    // Leaves of one triangle and no idea of wide nodes: the collapse decides both, at its own costs.
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.byteSize = sizeof(arguments);
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 256; // more than binning floats can reach; Embree fails where a mesh would need more
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = 1;
    arguments.bvh = tree.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    const auto *root = static_cast<const Item *>(rtcBuildBVH(&arguments));
    if (!root || leaves(*root) != primitives.size())
        throw Error(Exit::failed, "BVH",
                    fmt::format("Embree cannot build a tree over {} triangles: {} (error {})", primitives.size(),
                                message, int(rtcGetDeviceError(device.get()))));
    return copy_out(root, bounds);
}

} // namespace nacre::accel
