// Adds, removes and swaps the dips of a document, each as one undo step.
#pragma once

#include "workbench/document/Document.h"

namespace dipwright {

// Adds a second dip with the pose of the first, but rotated by a further 180° about X.
void addImmersion(Document& document);
void removeImmersion(Document& document, std::size_t number);
// Replaces all dips.
void setImmersions(Document& document, const std::vector<Immersion>& immersions);
// Does the same to try poses: tries in a row become one undo step.
void tryImmersions(Document& document, const std::vector<Immersion>& immersions);
// Gives each dip whose path goes through poses, but did not in `before`, poses of its path in
// `before`.
void fillPoses(Project& project, const Project& before);
// Adds a pose to the path of a dip, between the pose `before` and the next.
void addPathKey(Document& document, std::size_t dip, std::size_t before);
void removePathKey(Document& document, std::size_t dip, std::size_t key);
// Returns the depth of a dip.
Millimetres depthOf(const Project& project, std::size_t dip);
// Swaps the two dips. Marks for the seam stay with their dip.
void swapImmersions(Document& document);

} // namespace dipwright
