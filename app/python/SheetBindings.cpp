// The sheet of one dip: its pixels and its files.
#include "python/Arrays.h"
#include "python/Values.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "printing/PrintFile.h"
#include "project/FilmSizes.h"
#include "project/ProfileLibrary.h"
#include "python/Parts.h"
#include "python/Work.h"
#include "sheet/prepress/SheetFiles.h"

namespace dipwright::python {
namespace {

using PaperSize = std::variant<QString, std::tuple<double, double>>;

struct PrintedSheet : Dip {
    const Sheet& sheet() const { return (**this).sheet; }
};

constexpr double mostPaper = 5000; // mm

QSizeF paperSize(const PaperSize& paper) {
    if (const auto* name = std::get_if<QString>(&paper)) {
        return filmSize(*name);
    }
    const auto [width, height] = std::get<1>(paper);
    if (!(width > 0 && width <= mostPaper && height > 0 && height <= mostPaper)) {
        throw Error(QStringLiteral("The paper must be A4, A3, Letter or (width, height) in mm, up "
                                   "to 5000"),
                    QStringLiteral("tile_paper"));
    }
    return {width, height};
}

bool endsIn(const QString& path, const char* ending) {
    return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
}

void save(const PrintedSheet& sheet, const QString& path) {
    const auto write = endsIn(path, ".png") ? writeSheetPng : nullptr;
    if (write == nullptr && !endsIn(path, ".pdf") && !isTiff(path)) {
        throw Error(QStringLiteral("The file must end in .pdf, .png, .tif or .tiff"), path);
    }
    writeAtomically(path, [&](QIODevice& device) {
        if (write != nullptr) {
            write(sheet.sheet(), device);
        } else if (isTiff(path)) {
            writeSheetTiff(sheet.sheet(), device);
        } else {
            writeSheetPdf(sheet.sheet(), device);
        }
    });
}

PrintFileRequest printRequest(const PrintedSheet& sheet, const std::optional<QString>& profile,
                              const std::optional<PaperSize>& tilePaper, bool acceptClipping) {
    PrintFileRequest request;
    request.profile = sheet.run->project.profiles.printer;
    if (profile) {
        request.profile =
            std::get<PrinterProfile>(ProfileLibrary().profile(ProfileKind::Printer, *profile));
    }
    if (tilePaper) {
        request.tilePaper = paperSize(*tilePaper);
    }
    request.acceptClipping = acceptClipping;
    request.source = printSource(sheet.run->project, sheet.run.projectFile);
    return request;
}

// Warns of a sheet that was computed for another printer than the one that prints it.
QStringList computedForAnother(const Project& project, const PrinterProfile& printer) {
    if (printer.inkLimit == project.ink.limit && printer.resolution == project.sheet.resolution) {
        return {};
    }
    return {QStringLiteral("The sheet was computed with the ink limit and resolution of the "
                           "project, not of this printer profile; call Job.use_profile before the "
                           "run")};
}

std::vector<QString> printToFile(const PrintedSheet& sheet, const Path& path,
                                 const std::optional<QString>& profile,
                                 const std::optional<PaperSize>& tilePaper, bool acceptClipping) {
    const QString file = pathText(path);
    if (!endsIn(file, ".pdf") && !isTiff(file)) {
        throw Error(QStringLiteral("The file must end in .pdf, .tif or .tiff"), file);
    }
    const PrintFileRequest request = printRequest(sheet, profile, tilePaper, acceptClipping);
    return listOf(computed(py::none(), [&](const Progress&) {
        const QStringList warnings = writePrintFile(sheet.sheet(), request, file, PrintHistory());
        return (profile ? computedForAnother(sheet.run->project, *request.profile)
                        : QStringList()) +
               warnings;
    }));
}

std::map<QString, py::array> plates(const PrintedSheet& sheet) {
    std::map<QString, py::array> found;
    for (const SheetPlate& plate : sheet.sheet().plates) {
        found[plate.name] = pixels(plate.tint);
    }
    return found;
}

} // namespace

py::object sheetOf(const Dip& dip) {
    return py::cast(PrintedSheet{dip});
}

void bindSheet(py::module_& module) {
    py::class_<PrintedSheet>(module, "Sheet", "The sheet to print for one dip, at true size.")
        .def_property_readonly(
            "pixels", [](const PrintedSheet& sheet) { return pixels(sheet.sheet().image); },
            "The film image, ink side up: (height, width, 4) of red, green, blue and alpha. uint8 "
            "in\n"
            "sRGB; uint16 with the primaries of Rec. 2020 if sRGB would lose colour. Alpha 0 "
            "where\n"
            "nothing is printed. Shares the sheet's memory; read-only.")
        .def_property_readonly(
            "plates", plates,
            "White, varnish and spot colours by name: (height, width) uint8; 255 is full tint.")
        .def_property_readonly(
            "width_mm", [](const PrintedSheet& sheet) { return sheet.sheet().filmWidth.value(); },
            "Printed width of the film image, mm.")
        .def_property_readonly(
            "height_mm", [](const PrintedSheet& sheet) { return sheet.sheet().filmHeight.value(); },
            "Printed height of the film image, mm.")
        .def_property_readonly(
            "dpi",
            [](const PrintedSheet& sheet) { return sheet.sheet().settings.resolution.value(); },
            "Pixels per inch.")
        .def_property_readonly(
            "job_number", [](const PrintedSheet& sheet) { return sheet.sheet().job.hash; },
            "The number in the job line, which identifies image and settings.")
        .def(
            "save",
            [](const PrintedSheet& sheet, const Path& path) {
                runWork(py::none(), [&](const Progress&) { save(sheet, pathText(path)); });
            },
            py::arg("path"),
            "Writes the sheet at true size in sRGB: .pdf or .tif with marks and job line, .png "
            "the\n"
            "film image alone. Replaces the file. Raises Error.")
        .def(
            "print_to_file", printToFile, py::arg("path"), py::kw_only(),
            py::arg("profile") = py::none(), py::arg("tile_paper") = py::none(),
            py::arg("accept_clipping") = false,
            "Writes a .pdf or .tif in the scale and colours of a printer, as `dipwright-cli print\n"
            "--to` does, records it in the print history, and returns warnings.\n\n"
            "profile: name of a printer profile; default: the project's. tile_paper: splits the\n"
            "sheet into tiles for \"A4\", \"A3\", \"Letter\" or (width, height) in mm; PDF only.\n"
            "accept_clipping: accepts that colour outside the printable area is lost. Raises "
            "Error.")
        .def("__repr__", [](const PrintedSheet& sheet) {
            const QSize size = sheet.sheet().image.size();
            return QStringLiteral("<Sheet of %1 × %2 pixels, job %3>")
                .arg(size.width())
                .arg(size.height())
                .arg(sheet.sheet().job.hash);
        });
}

} // namespace dipwright::python
