// Finds the values that a shell can complete from a value's name in the help.
#pragma once

#include <QStringList>

namespace dipwright::cli {

struct ValueChoices {
    QStringList words;     // to be typed as they are
    bool files = false;    // any file
    bool folders = false;  // folders only
    bool projects = false; // *.dipw

    bool none() const { return words.isEmpty() && !files && !folders && !projects; }
};

// Reads alternatives such as "chessboard|FILE", "1|2", "DIR", "JOB.dipw" or "list | show KIND
// NAME". FILE, DIR and names that end in .dipw stand for files and folders. A shell cannot complete
// other words in capitals.
ValueChoices choicesOf(const QString& valueName);

} // namespace dipwright::cli
