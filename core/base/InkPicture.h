// Pictures whose pixels are amounts of cyan, magenta, yellow and black ink instead of colours. They
// are kept beside the colours of pictures in CMYK, so that a printer with the same inks prints the
// same amounts. All functions are reentrant.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

namespace dipwright {

// Identifies the colour space of an ICC profile by its contents. Copies of a profile have the same
// identity if only the rest of their header differs, such as date, flags and rendering intent. 32
// hexadecimal digits; empty for an empty profile.
QString iccIdentity(const QByteArray& profile);

// Returns an empty ink picture: Format_RGBA8888, whose four bytes per pixel are cyan, magenta,
// yellow and black, 0 no ink … 255 full. `space` is the iccIdentity() of its inks. Null if memory
// does not suffice. Never convert or smooth such a picture as if it had colours.
QImage inkPicture(QSize size, const QString& space);
// Returns the space of an ink picture; empty for any other picture. Copies of a picture and PNG
// files keep it.
QString inkSpace(const QImage& picture);
// The key under which a picture and its files store the space.
inline constexpr const char* inkSpaceKey = "Dipwright-Inks";

// The amounts of ink that a film shows, in two pictures that may be moved, turned and interpolated
// like colours. Both are RGBA8888 with alpha 0 where the film has nothing.
struct InkPlanes {
    QImage colours; // red, green, blue: the amounts of cyan, magenta, yellow
    // Red: the amount of black. Green: this film's share of the density at the place, 255 for all
    // of it. 0 says that there are no amounts here, and the colours are separated instead.
    QImage black;
    QString space; // of the inks; see iccIdentity()

    bool isNull() const { return colours.isNull(); }
    // Returns the planes with both pictures changed by `change`.
    template <typename Change>
    InkPlanes each(const Change& change) const {
        return isNull() ? *this : InkPlanes{change(colours), change(black), space};
    }
    bool operator==(const InkPlanes&) const = default;
};

// Returns the planes of an ink picture for a film that gives the whole density everywhere.
InkPlanes inkPlanes(const QImage& inks);

} // namespace dipwright
