// Makes the traveller: the printed pages, one or two per dip, that tell the person at the tank how
// to dip the part.
//
// The text is in the program's language; numbers use the decimal sign of this language.
#pragma once

#include "cradle/DatumPins.h"
#include "geometry/TriangleMesh.h"
#include "settings/Immersion.h"
#include "settings/Profile.h"
#include "traveller/Motion.h"
#include "traveller/PosePicture.h"

#include <QStringList>

namespace dipwright {

struct TravellerDip {
    Immersion immersion;
    QString job;              // job number, as on the sheet's job line
    int passes = 1;           // how many times the sheet is printed onto its film
    PosePicture front, right; // the body over the film, with its cradle
    double waterAtEnd = 0;    // y of the water level at the end of the dip, pose frame, mm
    bool hasCradle = false;   // whether a cradle holds the body in this dip
    QStringList cradleNotes;  // about the cradle, or why none is possible
    QStringList verdict;      // sentences: first the advice, then its reasons
    bool canBePrinted = true; // the advice is Advice::Print
    QImage sheet;             // film image at reduced size, ink side up
    BoundingBox body;         // bounding box, pose frame
    QImage after;             // how the body should look after this dip
    DipMotion motion;
};

struct Traveller {
    QString project, date;
    QString order; // a sentence about the number of parts, cost and time; may be empty
    FilmSettings film;
    ProjectProfiles profiles;
    DatumPins pins;
    MaskedAreas masked;             // surface that is taped before the first dip
    std::vector<TravellerDip> dips; // in the order of dipping
};

// Returns one job number for all sheets of a job: the sheet's own number if there is only one,
// otherwise hashOfJobs(). `jobs` holds the sheets' job numbers, at least one.
QString combinedJobNumber(const QStringList& jobs);

// Returns the job number of all dips together, which the QR code contains.
QString travellerJob(const Traveller& traveller);

// Writes A4 pages, one per dip. If a page has too little room for the pictures of the part after
// the dip, they are on a second one. The same traveller gives the same bytes in one language. Needs
// a QGuiApplication.
QByteArray travellerPdf(const Traveller& traveller);

} // namespace dipwright
