// Finds the values that a shell can complete for an option or argument, from the value's name in
// the help.
#pragma once

#include <QStringList>

namespace dipwright::cli {

struct ValueChoices {
    QStringList words;     // the words that the user types unchanged
    bool files = false;    // whether any file fits
    bool folders = false;  // whether only folders fit
    bool projects = false; // whether *.dipw files fit

    bool none() const { return words.isEmpty() && !files && !folders && !projects; }
};

// Returns the choices for a value's name such as "chessboard|FILE", "1|2", "DIR", "JOB.dipw" or
// "list | show KIND NAME". FILE, DIR and names that end in .dipw stand for files and folders. A
// shell cannot complete other words in capitals.
ValueChoices choicesOf(const QString& valueName);

} // namespace dipwright::cli
