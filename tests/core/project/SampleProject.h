// A small project that uses every part of the document, for tests.
#pragma once

#include "project/Project.h"

namespace dipwright::test {

// A box with two materials, one of them with a picture, and two dips. No value is the default.
Project sampleProject();

// Whether both projects would be saved with the same contents. Models are compared by content.
bool isSame(const Project& a, const Project& b);

} // namespace dipwright::test
