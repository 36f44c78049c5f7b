// What is to be said of a picture whose colours were not all read as they were meant. The note
// belongs to the picture: it is kept in its texts (QImage::text), goes with its copies, and is
// stored with it in PNG files. All functions are reentrant.
#pragma once

#include <QImage>
#include <QString>

namespace dipwright {

struct ColourNote {
    // The picture was in CMYK and named no ICC profile: its colours are a formula's.
    bool assumesInks = false;
    // Share of its pixels whose colours lie visibly beyond BT.2020 and were moved to its edge.
    double clipped = 0;
    bool isEmpty() const { return !assumesInks && clipped <= 0; }
};

QImage withColourNote(QImage picture, const ColourNote& note);
ColourNote colourNote(const QImage& picture);

// The text that keeps a note in a picture and its files: its name, without a space, which Qt takes
// for a description's; and what it says, empty for none.
inline constexpr const char* colourNoteKey = "Dipwright-Colours";
QString colourNoteValue(const QImage& picture);

// A sentence for the user; empty where there is nothing to say. `name`: of the picture.
QString colourNoteText(const QImage& picture, const QString& name);

} // namespace dipwright
