#pragma once
#include "io/load.h"
#include "io/source.h"
#include "io/tree.h"

namespace nacre::io {

/// Writes each `--set path=value` into `tree` and notes its path in `source.overridden`. Sections and fields that are
/// missing are made (a wrong name is then an unknown field when the tree is read); a material or an array element
/// that is missing is an error. Throws Error{Exit::input} whose subject is
/// `source.overrides`.
void apply_overrides(Json &tree, const std::vector<Override> &overrides, Source &source);

} // namespace nacre::io
