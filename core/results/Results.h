// Makes the result files of a run: VTK files, maps and proof pictures.
//
// The pictures contain text, which needs a QGuiApplication (the "offscreen" platform suffices). All
// functions are reentrant and return the same bytes for the same input.
#pragma once

#include "dip/Coverage.h"
#include "dip/LaidFilm.h"
#include "share/BodyShare.h"
#include "texture/ReverseTexture.h"

#include <QJsonObject>
#include <QRgb>

namespace dipwright {

// Return VTK XML PolyData files in the pose frame, with compressed float arrays
// (docs/files-and-commands.md, "Result files"). `appearance` gives the body's texture coordinates.
QByteArray filmVtp(const LaidFilm& laid, const SurfaceAppearance& appearance);
QByteArray bodyVtp(const PosedBody& body, const SurfaceAppearance& appearance,
                   const Coverage& coverage);

// Draws the mean stretch of each film point on the flat film, ink side up. Adds a labelled scale,
// the outline of the painted film and the statistics of its stretch. `longEdge` is the picture's
// longer side in pixels.
QImage stretchMap(const LaidFilm& laid, int longEdge);

// Draws where film on the body is compressed and may fold: the smaller principal stretch λ2, drawn
// like stretchMap(). White where nothing is compressed.
QImage wrinklingMap(const LaidFilm& laid, int longEdge);

// Draws the numerical error on the flat film, like stretchMap(), with marked film hatched.
// `changes` holds the error of each film point in mm; NaN where only one of the compared dips
// paints. The map shows it in `unit`. The scale ends at a few times `limit` (mm); higher values
// have a colour of their own.
QImage numericalErrorMap(const LaidFilm& laid, const std::vector<float>& changes, double limit,
                         int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// Draws how far handling may move the image, like numericalErrorMap(). `spread` holds the movement
// of each film point in mm; the map shows it in `unit`. The scale ends at a few times `limit` (mm).
QImage toleranceMap(const LaidFilm& laid, const std::vector<float>& spread, double limit,
                    int longEdge, LengthUnit unit = LengthUnit::Millimetre);

// Returns the names of the colour maps. All have even lightness steps: "lagoon" (dark blue, green,
// yellow), "dusk" (blue, grey, yellow; looks the same to any colour vision), "balance" (blue,
// near-white at 0.5, orange) and "grey". "lagoon" and "dusk" are lightest at the value 1.
QStringList colourMaps();
// Returns the colour at `value`, clamped to 0 … 1. Throws Error for an unknown map.
QColor mapColour(const QString& map, double value);

// Returns the colour of marked film in maps, proof and views.
QColor markColour(solver::PointMark mark);

// Returns the colour of a dip's share in maps and views.
QColor painterColour(Painter painter);

// One line of the legend for a shared body: a colour and its meaning.
struct ShareLine {
    QColor colour;
    QString text;
};
// Returns lines that state how much of the body each dip paints, in mm² and per cent, and the
// length of the seam. `dips` holds the names of the two dips.
std::vector<ShareLine> shareLines(const BodyShare& share, const QStringList& dips);

// Draws the whole flat film of dip `dip`, 0 or 1, ink side up, with the seam. Each place has the
// colour of the dips that paint the body there.
QImage sharePicture(const LaidFilm& laid, const BodyShare& share, std::size_t dip, QSize pixels);

// A placement error of the floating film, additional swell, and additional depth of the dip. The
// body then meets a different part of the picture. The film deforms as before, because it is nearly
// uniform. A greater depth uses the film of a deeper dip.
struct FilmPlacementError {
    std::array<Millimetres, 2> shift{}; // shift along the film's X and Z
    Degrees turn{0};                    // turn from X to Z about the film's centre
    double swell = 1;                   // factor on the film's size
    Millimetres deeper{0};              // negative: less deep
    bool operator==(const FilmPlacementError&) const = default;
};

// A spot colour's plate on a film.
struct PrintedSpot {
    QImage tints;  // tints on the flat film, Grayscale8
    QColor colour; // colour of full tint on white
};

// The film of one dip on the body, in the dip's pose, with its picture.
struct FilmAppearance {
    std::shared_ptr<const LaidFilm> laid;
    QImage image; // picture on the flat film
    FilmPlacementError slip = {};
    // Planned depth: mm from the body's lowest point up to the water at the end of the dip. If
    // `slip` is deeper, `laid` must come from a dip that is at least as deep.
    double depth = std::numeric_limits<double>::infinity();
    QImage white = {}; // tints of the white layer, Grayscale8; null: no white layer
    std::vector<PrintedSpot> spots = {}; // transparent like the other inks
};

// The surface below the ink.
struct Ground {
    // Colour of the bare body, seen through the ink where no white hides it. None: the bare body is
    // light grey, and ink looks as it does on white.
    std::optional<QColor> base = {};
    bool whiteOutside = false; // whether white was printed first, so that it lies over the colours
};

// Returns the colour at the centre of each triangle of `body` in white light, as in the proof. Uses
// all cores.
std::vector<QRgb> printedColours(const RefinedMesh& body, const std::vector<FilmAppearance>& films,
                                 const InkSettings& ink, const Ground& ground = {});

struct ProofOptions {
    QSize tile{640, 640}; // pixels of one view
    InkSettings ink = {}; // settings by which the images were compensated
    Ground ground = {};
};

// A body on a light table: the part of a proof that does not depend on the films.
struct ProofStage;
// Computes the stage by rays on all cores. `fine` is fineBody() of the model's mesh. The stage
// keeps a reference to the model; any thread may read it.
std::shared_ptr<const ProofStage> proofStage(const TexturedMesh& model,
                                             std::shared_ptr<const RefinedMesh> fine);
// Returns the ray queries of the stage's body.
const SurfaceQuery& queryOf(const ProofStage& stage);

// One dip of a body that two dips share.
struct SharedFilm {
    std::shared_ptr<const LaidFilm> laid;
    QString name; // name of the dip
};
// Draws which dip paints which area: the body from six sides, both flat films, and the sizes of the
// areas. `tile` is the side of one view in pixels. Throws Cancelled.
QImage coveragePicture(const ProofStage& stage, const BodyShare& share,
                       const std::vector<SharedFilm>& films, int tile, const Progress& progress);

// Draws the painted body in model orientation: front (along −Z), right and above in the upper row;
// back, left and below in the lower. The four sides are seen from slightly above. Densities of
// overlapping films add up, the bare body is light grey, and marked film is hatched. Uses all
// cores, without OpenGL. Throws Cancelled.
QImage proofPicture(const ProofStage& stage, const std::vector<FilmAppearance>& films,
                    const ProofOptions& options, const Progress& progress);

} // namespace dipwright
