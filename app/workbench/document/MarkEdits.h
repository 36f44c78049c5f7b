// Adds and removes the user's marks on the body: for the seam of two dips, and for zones.
#pragma once

#include "workbench/document/Document.h"

#include <variant>

namespace dipwright {

// The mark that a click on the body sets, without its place. monostate: no mark.
using MarkBrush = std::variant<std::monostate, ShareMark, ZoneMark>;

// Removes the oldest mark of the kind if the project holds the maximum number. Marks in a row are
// one undo step, until Document::endMerge().
void addMark(Document& document, const ShareMark& mark);
void addMark(Document& document, const ZoneMark& mark);

// Each is one undo step. `Mark` is ShareMark or ZoneMark.
template <typename Mark>
void removeLastMark(Document& document);
template <typename Mark>
void removeMarks(Document& document);

} // namespace dipwright
