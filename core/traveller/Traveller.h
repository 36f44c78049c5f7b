// What goes with a job to the tank: a page for each dip, to be printed and signed.
//
// The words are in the program's language; numbers have its decimal sign.
#pragma once

#include "cradle/DatumPins.h"
#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/Profile.h"
#include "traveller/Motion.h"
#include "traveller/PosePicture.h"

#include <QStringList>
#include <optional>

namespace dipwright {

struct TravellerDip {
    Immersion immersion;
    QString job;                       // as on its sheet's job line
    PosePicture front, right;          // as it hangs over the film, with its cradle
    double waterAtEnd = 0;             // mm of the pose frame: where the water stands in the end
    std::optional<QStringList> cradle; // its notes; none: no cradle was asked for
    QStringList verdict;               // what is to be done with the job, then why, in sentences
    QImage sheet;                      // the film's picture, ink side up, small
    BoundingBox body;                  // pose frame
    QImage after;                      // how the body has to look after it
    DipMotion motion;
};

struct Traveller {
    QString project, date;
    FilmSettings film;
    ProjectProfiles profiles;
    DatumPins pins;
    std::vector<TravellerDip> dips; // in their order
};

// The job of several sheets together, twelve hex digits: the one sheet's own, or of a SHA-256 over
// those of several. `jobs`: those of the sheets, at least one.
QString jobOfAll(const QStringList& jobs);

// That of all its dips: what the QR code holds.
QString travellerJob(const Traveller& traveller);

// A4 pages, one a dip. The same bytes for the same traveller in one language. Needs a
// QGuiApplication.
QByteArray travellerPdf(const Traveller& traveller);

} // namespace dipwright
