// What the user marks on the body as zones, each mark as one step to undo.
#pragma once

#include "document/Document.h"

namespace dipwright {

// Past mostZoneMarks the oldest goes.
void addZoneMark(Document& document, const ZoneMark& mark);
void removeLastZoneMark(Document& document);
void removeZoneMarks(Document& document);

} // namespace dipwright
