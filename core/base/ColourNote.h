// Notes on a picture that could not be read quite as intended. The note is kept in the
// picture's texts (QImage::text), so that copies keep it and PNG files store it. All functions are
// reentrant.
#pragma once

#include <QImage>
#include <QString>

namespace dipwright {

struct ColourNote {
    // The picture was in CMYK without an ICC profile, so a formula estimated its colours.
    bool assumesInks = false;
    // Share of the picture's pixels (0 … 1) whose colours lay visibly outside BT.2020. They were
    // moved to the edge of BT.2020.
    double clipped = 0;
    // The file says that the picture is to be shown turned or mirrored (EXIF), but its pixels are
    // used as they are stored.
    bool isTurned = false;
    // The file names a colour space in a way that is not read (cICP of PNG), so the colours count
    // as sRGB.
    bool assumesSrgb = false;
    bool isEmpty() const { return !assumesInks && clipped <= 0 && !isTurned && !assumesSrgb; }
};

QImage withColourNote(QImage picture, const ColourNote& note);
ColourNote colourNote(const QImage& picture);

// The key under which a picture and its files store the note. The key has no space, because Qt
// reads a key with a space as a description.
inline constexpr const char* colourNoteKey = "Dipwright-Colours";
// Returns the note in the form that is stored under colourNoteKey; empty if the picture has no
// note.
QString colourNoteValue(const QImage& picture);

// Returns the note as sentences for the user, without the last full stop; empty if there is no
// note. `name` is the picture's name.
QString colourNoteText(const QImage& picture, const QString& name);

} // namespace dipwright
