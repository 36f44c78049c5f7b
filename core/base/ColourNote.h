// Notes on a picture whose colours could not all be read as intended. The note is kept in the
// picture's texts (QImage::text), so that copies keep it and PNG files store it. All functions are
// reentrant.
#pragma once

#include <QImage>
#include <QString>

namespace dipwright {

struct ColourNote {
    // The picture was in CMYK without an ICC profile, so a formula estimated its colours.
    bool assumesInks = false;
    // Share of its pixels (0 … 1) whose colours lie visibly outside BT.2020 and were moved to its
    // edge.
    double clipped = 0;
    bool isEmpty() const { return !assumesInks && clipped <= 0; }
};

QImage withColourNote(QImage picture, const ColourNote& note);
ColourNote colourNote(const QImage& picture);

// The key under which a picture and its files store the note. It has no space, because Qt takes a
// key with a space for a description.
inline constexpr const char* colourNoteKey = "Dipwright-Colours";
// The note as it is stored under that key; empty if there is none.
QString colourNoteValue(const QImage& picture);

// Returns the note as a sentence for the user; empty if there is no note. `name` is the picture's
// name.
QString colourNoteText(const QImage& picture, const QString& name);

} // namespace dipwright
