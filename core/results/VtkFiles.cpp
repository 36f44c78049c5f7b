#include "results/Results.h"

#include <bit>
#include <map>
#include <new>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

namespace dipwright {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

QByteArray vtpBytes(vtkPolyData* data) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    writer->WriteToOutputStringOn();
    if (writer->Write() != 1) {
        throw std::bad_alloc(); // writing to memory fails for no other reason
    }
    return QByteArray::fromStdString(writer->GetOutputString());
}

vtkNew<vtkFloatArray> floatArray(const char* name, int components, std::size_t tuples) {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(vtkIdType(tuples));
    return array;
}

vtkNew<vtkUnsignedCharArray> byteArray(const char* name, std::size_t tuples) {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(vtkIdType(tuples));
    return array;
}

vtkNew<vtkPoints> points(const std::vector<Eigen::Vector3f>& positions) {
    vtkNew<vtkFloatArray> coordinates = floatArray("Points", 3, positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        coordinates->SetTypedTuple(vtkIdType(i), positions[i].data());
    }
    vtkNew<vtkPoints> result;
    result->SetData(coordinates);
    return result;
}

vtkNew<vtkCellArray> cells(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    vtkNew<vtkCellArray> result;
    result->AllocateExact(vtkIdType(triangles.size()), 3 * vtkIdType(triangles.size()));
    for (const auto& corners : triangles) {
        result->InsertNextCell(
            {vtkIdType(corners[0]), vtkIdType(corners[1]), vtkIdType(corners[2])});
    }
    return result;
}

// A body whose points each have one texture coordinate. Points on a chart's border are repeated for
// each chart.
struct SplitBody {
    std::vector<Eigen::Vector3f> positions;
    std::vector<Eigen::Vector2f> textureCoordinates;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

SplitBody splitAtSeams(const TriangleMesh& mesh, const SurfaceAppearance& appearance) {
    using Key = std::array<std::uint32_t, 3>; // bits, because NaN does not equal itself
    std::map<Key, std::uint32_t> known;
    SplitBody body;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t position = mesh.triangles[triangle][corner];
            const Eigen::Vector2f uv = appearance.textureCoordinates.empty()
                                           ? Eigen::Vector2f(none, none)
                                           : appearance.textureCoordinates[triangle][corner];
            const Key key{position, std::bit_cast<std::uint32_t>(uv.x()),
                          std::bit_cast<std::uint32_t>(uv.y())};
            const auto [entry, isNew] =
                known.try_emplace(key, std::uint32_t(body.positions.size()));
            if (isNew) {
                body.positions.push_back(mesh.positions[position]);
                body.textureCoordinates.push_back(uv);
            }
            corners[corner] = entry->second;
        }
        body.triangles.push_back(corners);
    }
    return body;
}

void addPrincipalStretches(const std::vector<PrincipalStretch>& stretches, vtkCellData& cells) {
    vtkNew<vtkFloatArray> larger = floatArray("larger_stretch", 1, stretches.size());
    vtkNew<vtkFloatArray> smaller = floatArray("smaller_stretch", 1, stretches.size());
    vtkNew<vtkFloatArray> area = floatArray("area_stretch", 1, stretches.size());
    for (std::size_t triangle = 0; triangle < stretches.size(); ++triangle) {
        larger->SetValue(vtkIdType(triangle), stretches[triangle].larger);
        smaller->SetValue(vtkIdType(triangle), stretches[triangle].smaller);
        area->SetValue(vtkIdType(triangle), stretches[triangle].area());
    }
    cells.AddArray(larger);
    cells.AddArray(smaller);
    cells.AddArray(area);
}

} // namespace

QByteArray filmVtp(const LaidFilm& laid, const SurfaceAppearance& appearance) {
    const DippedFilm& film = laid.film();
    const std::size_t count = film.grid.pointCount();
    const std::vector<float> stretches = pointStretches(film);
    vtkNew<vtkFloatArray> rest = floatArray("rest", 3, count);
    vtkNew<vtkUnsignedCharArray> adhered = byteArray("adhered", count);
    vtkNew<vtkUnsignedCharArray> marks = byteArray("marks", count);
    vtkNew<vtkFloatArray> uv = floatArray("uv", 2, count);
    vtkNew<vtkFloatArray> stretch = floatArray("stretch", 1, count);
    for (std::size_t point = 0; point < count; ++point) {
        const auto tuple = vtkIdType(point);
        const Eigen::Vector2f flat = restPosition(film.grid, point);
        rest->SetTuple3(tuple, flat.x(), 0, flat.y());
        adhered->SetValue(tuple, film.adhered(point) ? 1 : 0);
        marks->SetValue(tuple, film.marks.empty() ? 0 : film.marks[point]);
        const SurfacePoint& place = laid.contact().surface[point];
        const Eigen::Vector2f texture =
            place.isValid() ? appearance.textureCoordinate(place) : Eigen::Vector2f(none, none);
        uv->SetTypedTuple(tuple, texture.data());
        stretch->SetValue(tuple, stretches[point]);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points(film.positions));
    data->SetPolys(cells(laid.triangles()));
    data->GetPointData()->AddArray(rest);
    data->GetPointData()->AddArray(adhered);
    data->GetPointData()->AddArray(marks);
    data->GetPointData()->AddArray(uv);
    data->GetPointData()->AddArray(stretch);
    addPrincipalStretches(laid.stretches(), *data->GetCellData());
    return vtpBytes(data);
}

QByteArray bodyVtp(const PosedBody& body, const SurfaceAppearance& appearance,
                   const Coverage& coverage) {
    const SplitBody split = splitAtSeams(body.mesh, appearance);
    vtkNew<vtkFloatArray> texture = floatArray("TCoords", 2, split.positions.size());
    for (std::size_t i = 0; i < split.positions.size(); ++i) {
        texture->SetTypedTuple(vtkIdType(i), split.textureCoordinates[i].data());
    }
    vtkNew<vtkUnsignedCharArray> covered = byteArray("covered", split.triangles.size());
    vtkNew<vtkUnsignedCharArray> marks = byteArray("marks", split.triangles.size());
    for (std::size_t i = 0; i < split.triangles.size(); ++i) {
        covered->SetValue(vtkIdType(i), coverage.covered[i]);
        marks->SetValue(vtkIdType(i), coverage.marks[i]);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points(split.positions));
    data->SetPolys(cells(split.triangles));
    data->GetPointData()->SetTCoords(texture);
    data->GetCellData()->AddArray(covered);
    data->GetCellData()->AddArray(marks);
    return vtpBytes(data);
}

} // namespace dipwright
