// A small project with everything in it, for the tests of the document and of its store.
#pragma once

#include "project/Project.h"

namespace dipwright::test {

// A box with two materials, one of them with a picture; two immersions; no value at its default.
Project sampleProject();

// Whether what is saved of them is the same, models compared by content.
bool isSame(const Project& a, const Project& b);

} // namespace dipwright::test
