// What the user marks on the body: for the join of two dips, and as zones.
#pragma once

#include "workbench/document/Document.h"

#include <variant>

namespace dipwright {

// What a click on the body marks, without its place; none: nothing.
using MarkBrush = std::variant<std::monostate, ShareMark, ZoneMark>;

// Past the most marks that a project has, the oldest of the kind goes. Marks in a row are one step
// to undo until Document::endMerge().
void addMark(Document& document, const ShareMark& mark);
void addMark(Document& document, const ZoneMark& mark);

// Each one step to undo. `Mark` is ShareMark or ZoneMark.
template <typename Mark>
void removeLastMark(Document& document);
template <typename Mark>
void removeMarks(Document& document);

} // namespace dipwright
