// What is done to a document's immersions as a whole, each as one step to undo.
#pragma once

#include "document/Document.h"

namespace dipwright {

// A second one: the first one's pose, from the other side.
void addImmersion(Document& document);
void removeImmersion(Document& document, std::size_t number);

} // namespace dipwright
