// What the user paints on the body to say where the join of two dips may run, each mark as one step
// to undo.
#pragma once

#include "document/Document.h"

namespace dipwright {

// Past mostShareMarks the oldest goes. Marks in a row are one step until Document::endMerge().
void addShareMark(Document& document, const ShareMark& mark);
void removeLastShareMark(Document& document);
void removeShareMarks(Document& document);

} // namespace dipwright
