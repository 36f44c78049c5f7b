// Finds the place in the user guide that F1 opens for a widget.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace dipwright {

struct GuidePlace {
    int chapter = 0; // from 0, the same in all languages
    QString words;   // bold or italic words in that chapter; empty: its beginning
};

// Returns the place for `widget` or its nearest ancestor with a place; else the guide's beginning.
// `widget` may be null.
GuidePlace guidePlaceOf(const QWidget* widget);
std::vector<GuidePlace> guidePlaces(); // all places

} // namespace dipwright
