// What the user does with the photos of a film, of a dipped part and the places in them, each as
// one step to undo.
#pragma once

#include "settings/InspectedPart.h"
#include "workbench/document/Document.h"
#include "workbench/inspection/FitPage.h"

namespace dipwright {

// Those past mostInspectedPhotos are left out, and those that the project has already.
void addInspectedPhotos(Document& document, const std::vector<InspectedPhoto>& photos);
// With its pairs.
void removeInspectedPhoto(Document& document, std::size_t photo);
void addClickedPair(Document& document, const ClickedPair& pair);
// Of one drag, until Document::endMerge(), as one step.
void moveClickedPair(Document& document, std::size_t pair, QPointF pixel);
void removeClickedPair(Document& document, std::size_t pair);

// Those past mostFloatingPhotos are left out, and those that the project has already.
void addFloatingPhotos(Document& document, const std::vector<FloatingPhoto>& photos);
// Changes with the same `what` in a row are one step, where it is not empty.
void changeFilmOnWater(Document& document, const FilmOnWater& film, const QString& what);

// What is known of the parts dipped so far, with one more.
void keepBuilt(Document& document, const AsBuilt& built);
// Whether the next sheets are corrected, and by which share of what repeats.
void setCorrects(Document& document, bool corrects);
void setCorrectionStrength(Document& document, double strength);
// Throws Error where something is past what a project or profile may say.
void useFit(Document& document, const FittedPart& fitted, const WatchNotes& notes);

} // namespace dipwright
