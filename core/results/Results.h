// What a run leaves behind: VTK files, heatmaps, proof pictures, the report.
#pragma once

#include "dip/Coverage.h"
#include "texture/ReverseTexture.h"

#include <QJsonObject>

namespace dipwright {

// VTK XML PolyData as interfaces.md says, in the pose frame. Throws Error when not writable.
void writeFilmVtp(const DippedFilm& film, const FilmContact& contact, const PosedBody& body,
                  const QString& path);
void writeBodyVtp(const PosedBody& body, const Coverage& coverage, const QString& path);

// The mean stretch of each film point over the flat film, with a labelled scale; a perceptually
// uniform colour map that is safe for colour-blind readers. About `longEdge` pixels tall.
QImage stretchMap(const DippedFilm& film, const FilmContact& contact, int longEdge);

// A colour of a named map ("viridis", "cividis", "diverging" …) at 0 … 1.
QColor mapColour(const QString& map, double value);
QStringList colourMaps();

// One immersion's film wearing a picture, for the proof.
struct WornFilm {
    const DippedFilm* film = nullptr;
    const FilmContact* contact = nullptr;
    const PosedBody* body = nullptr;
    QImage image; // of the flat film
};

struct ProofOptions {
    QSize tile{800, 800};      // one view's pixels
    bool compensatedInk = true; // the images hold D·J: show D
};

// The body as it will come out, four views (front, right, back, left, from slightly above) side by
// side two by two, in model orientation; traced with Embree, without OpenGL.
QImage proofPicture(const TexturedMesh& model, const std::vector<WornFilm>& films,
                    const ProofOptions& options, const Progress& progress);

} // namespace dipwright
