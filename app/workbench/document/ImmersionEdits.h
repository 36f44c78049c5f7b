// What is done to a document's immersions as a whole, each as one step to undo.
#pragma once

#include "workbench/document/Document.h"

namespace dipwright {

// A second one: the first one's pose, from the other side.
void addImmersion(Document& document);
void removeImmersion(Document& document, std::size_t number);
// These in place of the document's.
void setImmersions(Document& document, const std::vector<Immersion>& immersions);
// Of two: the second dip first. What was given to a dip for the join stays that dip's.
void swapImmersions(Document& document);

} // namespace dipwright
