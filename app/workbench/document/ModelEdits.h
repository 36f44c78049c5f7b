// Changes the size of a document's model.
#pragma once

#include "workbench/document/Document.h"

namespace dipwright {

// Limits of the longest edge of a model.
inline constexpr Millimetres leastLongestEdge{1}, mostLongestEdge{3000};

// Scales the model, its marks and its artwork until the longest edge has this length. Changes in a
// row are one undo step, until Document::endMerge().
void resizeModel(Document& document, Millimetres longestEdge);

} // namespace dipwright
