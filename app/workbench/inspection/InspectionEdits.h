// Changes the photos of a film or a dipped part and the places in them, each as one undo step.
#pragma once

#include "settings/InspectedPart.h"
#include "workbench/document/Document.h"
#include "workbench/inspection/FitPage.h"

namespace dipwright {

// Skips photos that the project has already, and those above mostInspectedPhotos.
void addInspectedPhotos(Document& document, const std::vector<InspectedPhoto>& photos);
// Also removes its pairs.
void removeInspectedPhoto(Document& document, std::size_t photo);
void addClickedPair(Document& document, const ClickedPair& pair);
// The moves of one drag are one undo step, until Document::endMerge().
void moveClickedPair(Document& document, std::size_t pair, QPointF pixel);
void removeClickedPair(Document& document, std::size_t pair);

// Skips photos that the project has already, and those above mostFloatingPhotos.
void addFloatingPhotos(Document& document, const std::vector<FloatingPhoto>& photos);
// Changes in a row with the same `what` are one undo step, unless it is empty.
void changeFilmOnWater(Document& document, const FilmOnWater& film, const QString& what);

// Replaces the measured parts by `built`, which has one part more.
void keepBuilt(Document& document, const AsBuilt& built);
// Set whether the next sheets are corrected, and the share of the repeating error (0 to 1).
void setCorrects(Document& document, bool corrects);
void setCorrectionStrength(Document& document, double strength);
// Throws Error if a fitted value is outside the limits of a project or profile.
void useFit(Document& document, const FittedPart& fitted, const WatchNotes& notes);

} // namespace dipwright
