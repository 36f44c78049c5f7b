// Lists the faces of a CAD document with their names, colours and places. Private to this folder.
#pragma once

#include "import/cad/CadFile.h"

#include <QColor>

#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <vector>

namespace dipwright {

struct CadFace {
    TopoDS_Face face;      // as in its part
    TopLoc_Location place; // of the part
    QString name;          // not empty; no two faces have the same
    std::optional<QColor> colour;
};

struct CadFaces {
    std::vector<CadFace> faces;      // in the order of the file
    std::vector<TopoDS_Shape> parts; // in which the faces lie, each once, without a place
};

// Throws Error if there is no face or if there are too many. Joins the edges of neighbouring faces
// of a document whose faces do not share them.
CadFaces cadFaces(const CadDocument& document, const QString& path);

} // namespace dipwright
