#pragma once
#include "scene/bounds.h"

namespace nacre::scene {

/// Triangles that hang together by shared positions.
struct Shell {
    std::size_t triangles = 0;
    bool closed = true; // each of its edges has a triangle on both sides
    double volume = 0;  // signed, in cubic scene units: negative where it is turned inside out. Of use if closed.
    Bounds box;
};

/// How the triangles of a mesh meet. Vertices at exactly the same position are one.
struct Topology {
    std::size_t open_edges = 0;         // one triangle: a hole
    std::size_t non_manifold_edges = 0; // more than two triangles
    std::size_t inconsistent_edges = 0; // two triangles that go along it in the same direction
    std::vector<Shell> shells;
};

Topology find_topology(const Mesh &mesh);

/// Triangles with a vertex normal that points to their other side.
std::size_t count_opposed_normals(const Mesh &mesh);

} // namespace nacre::scene
