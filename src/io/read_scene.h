#pragma once
#include "io/fields.h"
#include "io/maps.h"

namespace nacre::io {

/// A scene being filled from a tree of JSON; the readers below each take one section of it.
struct Reading {
    scene::Scene &scene;
    const Source &source;
    Maps &maps;
};

// All of them throw Error{Exit::input}; `tree` is the section, null where the file leaves it out.

/// Reads image, render and device settings.
void read_settings(Fields &root, Reading &reading);

/// Materials by name; one that the scene has already is changed only where `tree` names a field.
void read_materials(const Json *tree, Reading &reading);

/// Meshes and shapes, transformed to world space.
void read_objects(const Json *tree, Reading &reading);

/// The camera; what it leaves open frames the objects, which must be there.
void read_camera(const Json *tree, Reading &reading);

void read_lights(const Json *tree, Reading &reading);

/// Reads a whole tree over `reading.scene`. `with_objects`: it has a section "objects" (glTF's are read before).
void read_scene(const Json &tree, bool with_objects, Reading &reading);

} // namespace nacre::io
