// Which place of the user guide tells about a part of the program: what F1 opens.
#pragma once

#include <QString>
#include <vector>

class QWidget;

namespace dipwright {

struct GuidePlace {
    int chapter = 0; // from 0, the same in all languages
    QString words;   // set off in that chapter's text; empty: where it begins
};

// Of `widget`, or of the nearest around it that has one; the guide's beginning for none or null.
GuidePlace guidePlaceOf(const QWidget* widget);
std::vector<GuidePlace> guidePlaces(); // all that there are

} // namespace dipwright
