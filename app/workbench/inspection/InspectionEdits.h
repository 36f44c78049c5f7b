// Changes the photos of a film or a dipped part and the places in them, each as one undo step.
#pragma once

#include "settings/InspectedPart.h"
#include "workbench/document/Document.h"
#include "workbench/inspection/FitPage.h"

namespace dipwright {

// Skips photos that the project has already, and photos beyond the limit mostInspectedPhotos.
void addInspectedPhotos(Document& document, const std::vector<InspectedPhoto>& photos);
// Also removes the photo's pairs.
void removeInspectedPhoto(Document& document, std::size_t photo);
void addClickedPair(Document& document, const ClickedPair& pair);
// The moves of one drag are one undo step, until Document::endMerge().
void moveClickedPair(Document& document, std::size_t pair, QPointF pixel);
void removeClickedPair(Document& document, std::size_t pair);

// Skips photos that the project has already, and photos beyond the limit mostFloatingPhotos.
void addFloatingPhotos(Document& document, const std::vector<FloatingPhoto>& photos);
// Consecutive changes with the same `what` are one undo step, unless `what` is empty.
void changeFilmOnWater(Document& document, const FilmOnWater& film, const QString& what);

// Replaces the measured parts by `built`, which has one part more.
void keepBuilt(Document& document, const AsBuilt& built);
// Sets whether the next sheets are corrected.
void setCorrects(Document& document, bool corrects);
// Sets the share of the repeating error that the next sheets correct, 0 to 1.
void setCorrectionStrength(Document& document, double strength);
// Throws Error if a fitted value is outside the limits of a project or profile, or if measured
// parts correct the project's sheets.
void useFit(Document& document, const FittedPart& fitted, const WatchNotes& notes);

} // namespace dipwright
