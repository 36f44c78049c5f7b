// Adds and removes the user's marks on the body: for the seam of two dips, for zones, and for
// masks.
#pragma once

#include "workbench/document/Document.h"

#include <variant>

namespace dipwright {

// The mark that a click on the body sets, without its place. monostate: no mark.
using MarkBrush = std::variant<std::monostate, ShareMark, ZoneMark, MaskMark>;

// Returns whether a brush draws strokes. Other brushes mark a whole face or material.
bool drawsStrokes(const MarkBrush& brush);
// Returns the brush that takes its area out of marks of the same kind.
MarkBrush eraserOf(const MarkBrush& brush);
// Sets the paths of a brush as marks, in one undo step. The brush must draw strokes. Throws Error
// if the project cannot hold more marks of the kind; it then stays unchanged.
void addStrokes(Document& document, const MarkBrush& brush, const std::vector<BrushPath>& paths);
// Sets the mark of a brush that draws no strokes, in one undo step. Throws Error as addStrokes().
// `material`: as SurfaceMark::material, for a mark of a whole material.
void addMark(Document& document, const MarkBrush& brush, const std::array<Millimetres, 3>& place,
             const QString& material = {});
// Returns the brush that marks all surface with one material. The brush must mark zones or masks.
MarkBrush materialBrush(const MarkBrush& brush);

// Each is one undo step. `Mark` is ShareMark, ZoneMark or MaskMark.
template <typename Mark>
void removeLastMark(Document& document);
template <typename Mark>
void removeMarks(Document& document);

} // namespace dipwright
