// What a shell may offer for a value, read off the name that help shows in its place.
#pragma once

#include <QStringList>

namespace dipwright::cli {

struct ValueChoices {
    QStringList words;     // to be typed as they stand
    bool files = false;    // any file
    bool folders = false;  // folders alone
    bool projects = false; // *.dipw

    bool none() const { return words.isEmpty() && !files && !folders && !projects; }
};

// "chessboard|FILE", "1|2", "DIR", "JOB.dipw", "list | show KIND NAME": alternatives in which FILE,
// DIR and names that end on .dipw stand for what they say, other capitals for what nobody can
// guess.
ValueChoices choicesOf(const QString& valueName);

} // namespace dipwright::cli
