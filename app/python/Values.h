// Exchanges texts, paths and values of a project with Python. Private to this folder.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "project/ProjectValues.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <filesystem>

namespace pybind11::detail {

// QString is Python's str.
template <>
struct type_caster<QString> {
    PYBIND11_TYPE_CASTER(QString, const_name("str"));

    bool load(handle source, bool) {
        if (!PyUnicode_Check(source.ptr())) {
            return false;
        }
        value = QString::fromStdString(source.cast<std::string>());
        return true;
    }
    static handle cast(const QString& text, return_value_policy, handle) {
        return str(text.toStdString()).release();
    }
};

} // namespace pybind11::detail

namespace dipwright::python {

namespace py = pybind11;

// A path as Python gives it: str or os.PathLike.
using Path = std::filesystem::path;
QString pathText(const Path& path);
QString pathText(const std::optional<Path>& path); // empty without a path

std::vector<QString> listOf(const QStringList& texts);

// Returns the value as Python's None, bool, int, float, str, tuple, or, for lists, list. Numbers
// are float unless the rule wants whole numbers.
py::object toPython(const ProjectValue& value);
// Returns the object as a dict, as the module json reads it.
py::object toPython(const QJsonObject& object);
// Returns the value of a bool of Python or NumPy; nothing for other objects.
std::optional<bool> boolOf(const py::handle& value);
// Returns the text from which setByPath() reads the new value of `old`: a str itself, otherwise the
// parts of a tuple, the items of a list, or the JSON of a list of marks. Throws py::type_error for
// other objects.
QString settingText(const ProjectValue& old, const py::object& value);

} // namespace dipwright::python
