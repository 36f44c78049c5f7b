// What is done to a document's model, as one step to undo.
#pragma once

#include "workbench/document/Document.h"

namespace dipwright {

// How long the longest edge of a model may be made.
inline constexpr Millimetres leastLongestEdge{1}, mostLongestEdge{3000};

// Makes the model larger or smaller until its longest edge measures this, and moves what is marked
// on it along. Steps in a row become one, until Document::endMerge().
void resizeModel(Document& document, Millimetres longestEdge);

} // namespace dipwright
