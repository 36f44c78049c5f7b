// The verdict on a sheet, with its reasons and the places to check.
#include "python/Values.h"

#include "pipeline/JobVerdict.h"
#include "python/Parts.h"

namespace dipwright::python {
namespace {

using Point2 = std::tuple<double, double>;
using Point3 = std::tuple<double, double, double>;

struct Reason {
    VerdictReason reason;
    QString text;
    std::optional<std::size_t> immersion;
};

struct JudgedVerdict {
    Advice advice = Advice::NotJudged;
    std::vector<Reason> reasons;
    std::vector<PlaceToCheck> places;

    QString text() const {
        QStringList sentences{adviceText(advice) + u'.'};
        for (const Reason& reason : reasons) {
            sentences.append(reason.text);
        }
        return sentences.join(u' ');
    }
};

} // namespace

py::object verdictOf(const Dip& dip) {
    JudgedVerdict verdict{dip->verdict.advice, {}, dip->verdict.places};
    for (const VerdictReason& reason : dip->verdict.reasons) {
        verdict.reasons.push_back({reason, reasonText(reason, millimetres), dip.number});
    }
    return py::cast(verdict);
}

py::object verdictOf(const Run& run) {
    JudgedVerdict verdict{adviceOf(*run), {}, run->verdict.places};
    for (const JobReason& reason : reasonsOf(*run)) {
        verdict.reasons.push_back(
            {reason.reason, reasonText(reason, *run, millimetres), reason.dip});
    }
    return py::cast(verdict);
}

void bindVerdict(py::module_& module) {
    py::class_<Reason>(module, "Reason", "One reason for a verdict. str() gives its sentence.")
        .def_property_readonly(
            "kind", [](const Reason& reason) { return reasonKey(reason.reason.kind); },
            "What it is about, as in report.json: \"air\", \"off_by\" …")
        .def_property_readonly(
            "advice", [](const Reason& reason) { return adviceKey(reason.reason.advice); },
            "The verdict if this were the only reason.")
        .def_property_readonly(
            "value", [](const Reason& reason) { return reason.reason.value; },
            "Its figure: mm for errors and distances, mm/s or °/s for speeds, a share 0 to 1 for "
            "areas.")
        .def_property_readonly(
            "limit", [](const Reason& reason) { return reason.reason.limit; },
            "The limit for the figure; 0: none.")
        .def_readonly("immersion", &Reason::immersion,
                      "Number of the dip, from 0; None if it is about all dips together.")
        .def_readonly("text", &Reason::text, "The sentence.")
        .def("__str__", [](const Reason& reason) { return reason.text; })
        .def("__repr__", [](const Reason& reason) {
            return QStringLiteral("<Reason %1: %2>")
                .arg(reasonKey(reason.reason.kind), reason.text);
        });

    py::class_<PlaceToCheck>(module, "PlaceToCheck",
                             "A part of the painted film to check before printing.")
        .def_property_readonly(
            "rest",
            [](const PlaceToCheck& place) {
                return Point2(double(place.rest.x()), double(place.rest.y()));
            },
            "Worst point on the flat film: x and z from its centre, mm.")
        .def_property_readonly(
            "place",
            [](const PlaceToCheck& place) {
                return Point3(double(place.place.x()), double(place.place.y()),
                              double(place.place.z()));
            },
            "The same point on the part: x, y, z in model coordinates, mm.")
        .def_readonly("area", &PlaceToCheck::area, "Area on the part, mm².")
        .def_readonly("limit", &PlaceToCheck::limit, "Allowed numerical error, mm.")
        .def_readonly("off_by", &PlaceToCheck::offBy, "Numerical error, mm.")
        .def("__repr__", [](const PlaceToCheck& place) {
            return QStringLiteral("<PlaceToCheck of %1 mm²>").arg(place.area, 0, 'f', 0);
        });

    py::class_<JudgedVerdict>(module, "Verdict",
                              "Whether to print. str() gives it in words, with every reason.")
        .def_property_readonly(
            "advice", [](const JudgedVerdict& verdict) { return adviceKey(verdict.advice); },
            "\"print\", \"look_first\", \"do_not_print\" or \"not_judged\", as in report.json.")
        .def_readonly("reasons", &JudgedVerdict::reasons, "All reasons, the worst first.")
        .def_readonly("places", &JudgedVerdict::places, "Places to check, the largest first.")
        .def_property_readonly("text", &JudgedVerdict::text, "The verdict in words.")
        .def("__str__", &JudgedVerdict::text)
        .def("__repr__", [](const JudgedVerdict& verdict) {
            return QStringLiteral("<Verdict %1: %2>")
                .arg(adviceKey(verdict.advice), verdict.text());
        });
}

} // namespace dipwright::python
