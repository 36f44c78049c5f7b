#include "python/Values.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace dipwright::python {
namespace {

bool isSequence(const py::handle& value) {
    return PySequence_Check(value.ptr()) != 0 && !py::isinstance<py::str>(value) &&
           !py::isinstance<py::dict>(value) && !py::isinstance<py::bytes>(value) &&
           !py::isinstance<py::bytearray>(value);
}

QString partText(const py::handle& value) {
    if (value.is_none()) {
        return QStringLiteral("null");
    }
    if (const std::optional<bool> flag = boolOf(value)) {
        return *flag ? QStringLiteral("true") : QStringLiteral("false");
    }
    if (py::isinstance<py::str>(value)) {
        if (PyUnicode_AsUTF8(value.ptr()) == nullptr) { // as for a lone surrogate
            throw py::error_already_set();
        }
        return value.cast<QString>();
    }
    if (PyLong_Check(value.ptr())) {
        return py::repr(value).cast<QString>();
    }
    if (PyNumber_Check(value.ptr()) != 0) {
        return py::repr(py::float_(py::reinterpret_borrow<py::object>(value))).cast<QString>();
    }
    throw py::type_error("a value of a project is None, a bool, a number, a str, or a sequence of "
                         "these, not " +
                         py::repr(py::type::of(value)).cast<std::string>());
}

QString joined(const py::handle& value, QChar separator, QString (*text)(const py::handle&)) {
    QStringList parts;
    for (const py::handle& part : py::reinterpret_borrow<py::object>(value)) {
        parts.append(text(part));
    }
    return parts.join(separator);
}

QString itemText(const py::handle& value) {
    return isSequence(value) ? joined(value, u';', partText) : partText(value);
}

py::object loaded(const QByteArray& json, bool wholeNumbers) {
    const auto loads = py::module_::import("json").attr("loads");
    const py::str text(json.constData(), std::size_t(json.size()));
    return wholeNumbers ? loads(text)
                        : loads(text, py::arg("parse_int") = py::type::of(py::float_(0.0)));
}

} // namespace

std::optional<bool> boolOf(const py::handle& value) {
    constexpr bool withConversions = false;
    py::detail::make_caster<bool> caster;
    return caster.load(value, withConversions) ? std::optional(bool(caster)) : std::nullopt;
}

QString pathText(const Path& path) {
    return QString::fromStdString(path.string());
}

QString pathText(const std::optional<Path>& path) {
    return path ? pathText(*path) : QString();
}

std::vector<QString> listOf(const QStringList& texts) {
    return {texts.begin(), texts.end()};
}

py::object toPython(const ProjectValue& value) {
    const bool isWhole = value.rule.kind != FieldKind::Number;
    const py::list read =
        loaded(QJsonDocument(QJsonArray{value.value}).toJson(QJsonDocument::Compact), isWhole);
    const py::object first = read[0];
    const bool isParts = value.rule.parts > 1 && value.rule.mostItems == 0;
    return isParts && py::isinstance<py::list>(first) ? py::object(py::tuple(first)) : first;
}

py::object toPython(const QJsonObject& object) {
    return loaded(QJsonDocument(object).toJson(QJsonDocument::Compact), true);
}

QString settingText(const ProjectValue& old, const py::object& value) {
    if (!isSequence(value)) {
        return partText(value);
    }
    if (old.isMarks) {
        return py::module_::import("json").attr("dumps")(value).cast<QString>();
    }
    return old.rule.mostItems > 0 ? joined(value, u'/', itemText) : itemText(value);
}

} // namespace dipwright::python
