#include "base/ColourNote.h"

#include "base/NumberText.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ColourNote)
};

const QString key = QString::fromLatin1(colourNoteKey);
const QString inks = QStringLiteral("assumed-inks");
const QString turned = QStringLiteral("turned");
const QString srgb = QStringLiteral("assumed-srgb");
const QString beyond = QStringLiteral("clipped=");

QString valueOf(const ColourNote& note) {
    QStringList parts;
    if (note.assumesInks) {
        parts << inks;
    }
    if (note.clipped > 0) {
        parts << beyond + QString::number(note.clipped, 'g', 4);
    }
    if (note.isTurned) {
        parts << turned;
    }
    if (note.assumesSrgb) {
        parts << srgb;
    }
    return parts.join(u' ');
}

} // namespace

QImage withColourNote(QImage picture, const ColourNote& note) {
    picture.setText(key, valueOf(note));
    return picture;
}

ColourNote colourNote(const QImage& picture) {
    ColourNote note;
    for (const QString& part : picture.text(key).split(u' ')) {
        note.assumesInks = note.assumesInks || part == inks;
        note.isTurned = note.isTurned || part == turned;
        note.assumesSrgb = note.assumesSrgb || part == srgb;
        if (part.startsWith(beyond)) {
            const double share = part.mid(beyond.size()).toDouble(); // 0 if it is not a number
            note.clipped = share > 0 ? std::min(share, 1.0) : 0;
        }
    }
    return note;
}

QString colourNoteValue(const QImage& picture) {
    return valueOf(colourNote(picture));
}

QString colourNoteText(const QImage& picture, const QString& name) {
    const ColourNote note = colourNote(picture);
    QStringList sentences;
    if (note.isTurned) {
        sentences << Text::tr("%1 is to be shown turned or mirrored, as its EXIF data says, but it "
                              "is used as its pixels are stored; save it upright in an image "
                              "program")
                         .arg(name);
    }
    if (note.assumesSrgb) {
        sentences << Text::tr(
                         "%1 names its colour space in a cICP chunk, which is not read, so its "
                         "colours count as sRGB and can be wrong; save it with an ICC profile, "
                         "or as sRGB")
                         .arg(name);
    }
    if (note.assumesInks) {
        sentences << Text::tr("%1 is in CMYK and has no ICC profile, so its colours are only "
                              "estimated and can be wrong; save it with its profile, or as sRGB")
                         .arg(name);
    } else if (note.clipped > 0) {
        const double percent = std::max(0.1, 100 * note.clipped);
        sentences << Text::tr(
                         "%1 has colours outside BT.2020, the largest colour space used here: %2 % "
                         "of its pixels are printed less saturated; to control this, save it in a "
                         "smaller colour space, such as Adobe RGB")
                         .arg(name, numberText(percent, 1));
    }
    return sentences.join(QStringLiteral(". "));
}

} // namespace dipwright
