#include "sheet/pdf/InkedPages.h"

#include "sheet/pdf/DrawnPdf.h"
#include "sheet/pdf/ImageObject.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <algorithm>
#include <climits>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>

namespace dipwright {
namespace {

// Returns the number without an exponent, which PDF does not allow.
QByteArray plain(double number) {
    return QByteArray::number(number, 'f', 9);
}

QByteArray matrix(const QTransform& t) {
    QByteArray text;
    for (const double number : {t.m11(), t.m12(), t.m21(), t.m22(), t.dx(), t.dy()}) {
        text += plain(number) + ' ';
    }
    return text + "cm\n";
}

QByteArray point(const QPointF& at) {
    return plain(at.x()) + ' ' + plain(at.y()) + ' ';
}

QByteArray construction(const QPainterPath& path) {
    QByteArray text;
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::Element element = path.elementAt(i);
        switch (element.type) {
        case QPainterPath::MoveToElement:
            text += point(element) + "m\n";
            break;
        case QPainterPath::LineToElement:
            text += point(element) + "l\n";
            break;
        case QPainterPath::CurveToElement:
            text += point(element) + point(path.elementAt(i + 1)) + point(path.elementAt(i + 2)) +
                    "c\n";
            i += 2;
            break;
        case QPainterPath::CurveToDataElement:
            break;
        }
    }
    return text;
}

// Returns the operator that sets the ink of lines (`stroke`) or of areas.
QByteArray ink(const QColor& colour, bool stroke) {
    if (colour == registrationBlack) {
        return stroke ? "/All CS 1 SCN\n" : "/All cs 1 scn\n";
    }
    const bool isCmyk = colour.spec() == QColor::Cmyk;
    const double black = 1 - qGray(colour.rgb()) / 255.0;
    QByteArray text;
    for (const double share :
         {isCmyk ? double(colour.cyanF()) : 0, isCmyk ? double(colour.magentaF()) : 0,
          isCmyk ? double(colour.yellowF()) : 0, isCmyk ? double(colour.blackF()) : black}) {
        text += plain(share) + ' ';
    }
    return text + (stroke ? "K\n" : "k\n");
}

QByteArray lineStyle(const QPen& pen) {
    const int cap = pen.capStyle() == Qt::FlatCap ? 0 : pen.capStyle() == Qt::RoundCap ? 1 : 2;
    const int join = pen.joinStyle() == Qt::RoundJoin   ? 1
                     : pen.joinStyle() == Qt::BevelJoin ? 2
                                                        : 0;
    QByteArray dashes;
    for (const qreal dash : pen.dashPattern()) {
        dashes += plain(dash * pen.widthF()) + ' ';
    }
    return plain(pen.widthF()) + " w " + QByteArray::number(cap) + " J " +
           QByteArray::number(join) + " j [" + dashes + "] 0 d\n";
}

// Turns what a painter draws into the operators of a page.
class InkEngine : public QPaintEngine {
public:
    // `picture` holds the operators that draw the film's picture into a square of 1 × 1.
    explicit InkEngine(QByteArray picture)
        : QPaintEngine(AllFeatures), picture_(std::move(picture)) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState&) override {} // the engine asks the painter instead
    void drawPath(const QPainterPath& path) override {
        const QPen pen = painter()->pen();
        const QBrush brush = painter()->brush();
        if (brush.style() != Qt::NoBrush) {
            const char* rule = path.fillRule() == Qt::WindingFill ? "f\n" : "f*\n";
            add(ink(brush.color(), false) + construction(path) + rule);
        }
        if (pen.style() != Qt::NoPen) {
            add(ink(pen.color(), true) + lineStyle(pen) + construction(path) + "S\n");
        }
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        QPainterPath path;
        path.addPolygon(QPolygonF(QList<QPointF>(points, points + count)));
        if (mode != PolylineMode) {
            path.closeSubpath();
        }
        drawPath(path);
    }
    void drawPixmap(const QRectF& box, const QPixmap&, const QRectF&) override { place(box); }
    void drawImage(const QRectF& box, const QImage&, const QRectF&,
                   Qt::ImageConversionFlags) override {
        place(box);
    }

    void strokeCut(const QPainterPath& path, double width, const SpotInk& spot, double bleed) {
        const QByteArray name = spotName(spot);
        add("/Cut gs /" + name + " CS 1 SCN\n" + lineStyle(QPen(Qt::black, width)) +
            construction(path) + "S\n");
        if (bleed > 0) {
            const QTransform onPage = painter()->combinedTransform();
            trim_ = trim_.united(onPage.mapRect(path.boundingRect()));
            bleed_ = trim_.united(
                onPage.mapRect(path.boundingRect().adjusted(-bleed, -bleed, bleed, bleed)));
        }
    }
    // Returns the trim box in points from the page's upper left corner; empty: the page's own box.
    const QRectF& trim() const { return trim_; }
    const QRectF& bleed() const { return bleed_; }
    // Returns the name of a spot ink's colour space on the page.
    QByteArray spotName(const SpotInk& spot) {
        const auto found = std::find_if(spots_.begin(), spots_.end(), [&](const SpotInk& known) {
            return known.name == spot.name;
        });
        const auto index = found - spots_.begin();
        if (found == spots_.end()) {
            spots_.push_back(spot);
        }
        return "Spot" + QByteArray::number(int(index));
    }

    const QByteArray& content() const { return content_; }
    const std::vector<SpotInk>& spots() const { return spots_; }

private:
    void add(const QByteArray& operators) {
        content_ += "q\n";
        const QTransform transform = painter()->combinedTransform();
        content_ += matrix(transform);
        if (painter()->hasClipping()) {
            content_ += construction(painter()->clipPath()) + "W n\n";
        }
        content_ += operators + "Q\n";
    }
    // Draws the film's picture in the box. In PDF, an image fills a square of 1 × 1, first row on
    // top.
    void place(const QRectF& box) {
        add(matrix(QTransform(box.width(), 0, 0, -box.height(), box.x(), box.bottom())) + picture_);
    }

    QByteArray picture_;
    QByteArray content_;
    std::vector<SpotInk> spots_;
    QRectF trim_, bleed_;
};

// A page in points, with its origin in the upper left corner.
class InkPage : public QPaintDevice {
public:
    InkPage(QSizeF size, const QByteArray& picture) : size_(size), engine_(picture) {}
    QPaintEngine* paintEngine() const override { return &engine_; }
    InkEngine& engine() const { return engine_; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return int(std::ceil(size_.width()));
        case PdmHeight:
            return int(std::ceil(size_.height()));
        case PdmWidthMM:
            return int(size_.width() / 72 * 25.4);
        case PdmHeightMM:
            return int(size_.height() / 72 * 25.4);
        case PdmNumColors:
            return INT_MAX;
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 72;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return int(devicePixelRatioFScale());
        }
        return 0;
    }

private:
    QSizeF size_;
    mutable InkEngine engine_;
};

// Returns a PDF name. qpdf escapes all characters that need it but #, which begins an escape.
QPDFObjectHandle name(QString text) {
    text.replace(QLatin1Char('#'), QLatin1String("#23"));
    return QPDFObjectHandle::newName((QLatin1Char('/') + text).toStdString());
}

// Returns [/Separation /Name /DeviceCMYK function].
QPDFObjectHandle separation(QPDF& pdf, const SpotInk& spot) {
    QByteArray full;
    for (const double share : spot.alternate) {
        full += QByteArray::number(share) + ' ';
    }
    QPDFObjectHandle space = QPDFObjectHandle::newArray();
    space.appendItem(QPDFObjectHandle::newName("/Separation"));
    space.appendItem(name(spot.name));
    space.appendItem(QPDFObjectHandle::newName("/DeviceCMYK"));
    space.appendItem(QPDFObjectHandle::parse(
        "<< /FunctionType 2 /Domain [0 1] /C0 [0 0 0 0] /C1 [" + full.toStdString() + "] /N 1 >>"));
    return pdf.makeIndirectObject(space);
}

// Compresses without loss (FlateDecode). qCompress() writes the length before the data; PDF does
// not want it.
QPDFObjectHandle compressed(QPDF& pdf, const QByteArray& bytes) {
    const QByteArray packed = qCompress(bytes).mid(4);
    QPDFObjectHandle stream = QPDFObjectHandle::newStream(&pdf);
    stream.replaceStreamData(packed.toStdString(), QPDFObjectHandle::newName("/FlateDecode"),
                             QPDFObjectHandle::newNull());
    return stream;
}

// Returns the plates' images in printing order.
std::vector<QPDFObjectHandle> plateImages(QPDF& pdf, const PackedPlates& plates) {
    std::vector<QPDFObjectHandle> images;
    if (plates.size.isEmpty()) { // pages without a picture
        return images;
    }
    const auto add = [&](bool first) {
        for (const PackedPlates::Spot& plate : plates.spots) {
            if (plate.first == first) {
                images.push_back(imageObject(pdf, plate.tint, separation(pdf, plate.ink)));
            }
        }
    };
    add(true);
    images.push_back(imageObject(pdf, plates.cmyk, QPDFObjectHandle::newName("/DeviceCMYK")));
    add(false);
    return images;
}

// The film's picture on a page: operators that draw it into a square of 1 × 1, and the objects that
// they name.
struct Picture {
    QByteArray operators;
    QPDFObjectHandle resources; // a dictionary
};

QByteArray drawn(std::size_t images) {
    QByteArray operators = images > 1 ? "/Over gs\n" : "";
    for (std::size_t plate = 0; plate < images; ++plate) {
        operators += "/Plate" + QByteArray::number(int(plate)) + " Do\n";
    }
    return operators;
}

// Returns the picture. With the blend mode Multiply, a plate removes no ink of the other plates, on
// screens and in separations (ISO 32000-1, 11.7.3). The plates blend in a transparency group of
// their own, so that nothing else on the page is in a group; cutters may not find a contour in
// flattened transparency. Overprinting needs no group, but many viewers ignore it, and white then
// hides the other plates. A single image has neither.
Picture pictureOf(QPDF& pdf, const PackedPlates& plates, PdfTarget target) {
    const std::vector<QPDFObjectHandle> images = plateImages(pdf, plates);
    const bool blends = images.size() > 1 && target == PdfTarget::Ghostscript;
    const bool overprints = images.size() > 1 && !blends;
    QPDFObjectHandle objects = QPDFObjectHandle::newDictionary();
    for (std::size_t plate = 0; plate < images.size(); ++plate) {
        objects.replaceKey("/Plate" + std::to_string(plate), images[plate]);
    }
    const std::string over = std::string("/Over << ") + (blends ? "/BM /Multiply " : "") +
                             (overprints ? "/OP true /op true /OPM 1 " : "") + ">> ";
    const std::string cut = "/Cut << /OP true /op true /OPM 1 >> ";
    const auto resources = [](const std::string& states, const QPDFObjectHandle& things) {
        QPDFObjectHandle made = QPDFObjectHandle::parse("<< /ExtGState << " + states + ">> >>");
        made.replaceKey("/XObject", things);
        return made;
    };
    if (!blends) {
        return {drawn(images.size()), resources(over + cut, objects)};
    }
    QPDFObjectHandle group = compressed(pdf, drawn(images.size()));
    QPDFObjectHandle form = group.getDict();
    form.replaceKey("/Type", QPDFObjectHandle::newName("/XObject"));
    form.replaceKey("/Subtype", QPDFObjectHandle::newName("/Form"));
    form.replaceKey("/BBox", QPDFObjectHandle::newFromRectangle({0, 0, 1, 1}));
    form.replaceKey("/Group",
                    QPDFObjectHandle::parse("<< /S /Transparency /CS /DeviceCMYK /I true >>"));
    form.replaceKey("/Resources", resources(over, objects));
    QPDFObjectHandle groups = QPDFObjectHandle::newDictionary();
    groups.replaceKey("/Plates", group);
    return {"/Plates Do\n", resources(cut, groups)};
}

QPDFObjectHandle boxOf(QSizeF points) {
    return QPDFObjectHandle::newFromRectangle({0, 0, points.width(), points.height()});
}

// Returns a PDF box. `box` is measured from the upper left corner of the page.
QPDFObjectHandle boxOf(QRectF box, QSizeF page) {
    box = box.intersected(QRectF(QPointF(), page));
    return QPDFObjectHandle::newFromRectangle(
        {box.left(), page.height() - box.bottom(), box.right(), page.height() - box.top()});
}

void setBoxes(QPDFObjectHandle page, QSizeF size, const InkEngine& drawn) {
    page.replaceKey("/MediaBox", boxOf(size));
    page.replaceKey("/TrimBox", drawn.trim().isEmpty() ? boxOf(size) : boxOf(drawn.trim(), size));
    if (!drawn.trim().isEmpty()) {
        page.replaceKey("/BleedBox", boxOf(drawn.bleed(), size));
    }
}

} // namespace

bool isInkedPage(const QPainter& painter) {
    return dynamic_cast<const InkPage*>(painter.device()) != nullptr;
}

void strokeCut(QPainter& painter, const QPainterPath& path, double width, const SpotInk& spot,
               double bleed) {
    const auto* page = dynamic_cast<const InkPage*>(painter.device());
    if (page && !path.isEmpty()) {
        page->engine().strokeCut(path, width, spot, bleed);
    }
}

void addInkedPages(QPDF& pdf, const std::vector<PdfPage>& pages, const PackedPlates& plates,
                   PdfTarget target) {
    const QPDFObjectHandle all = separation(pdf, {QStringLiteral("All"), {1, 1, 1, 1}});
    const Picture picture = pictureOf(pdf, plates, target);
    QPDFPageDocumentHelper document(pdf);
    for (const PdfPage& one : pages) {
        const QSizeF size = inPoints(one.size);
        InkPage drawn(size, picture.operators);
        QPainter painter(&drawn);
        painter.scale(inPoints(QSizeF(1, 1)).width(), inPoints(QSizeF(1, 1)).height());
        one.paint(painter);
        painter.end();
        QPDFObjectHandle spaces = QPDFObjectHandle::newDictionary();
        spaces.replaceKey("/All", all);
        for (const SpotInk& spot : drawn.engine().spots()) {
            spaces.replaceKey(('/' + drawn.engine().spotName(spot)).toStdString(),
                              separation(pdf, spot));
        }
        QPDFObjectHandle resources = picture.resources;
        resources = resources.shallowCopy(); // each page has its own colour spaces
        resources.replaceKey("/ColorSpace", spaces);
        const QByteArray turned = matrix(QTransform(1, 0, 0, -1, 0, size.height()));
        QPDFObjectHandle page = QPDFObjectHandle::parse("<< /Type /Page >>");
        setBoxes(page, size, drawn.engine());
        page.replaceKey("/Resources", resources);
        page.replaceKey("/Contents", compressed(pdf, turned + drawn.engine().content()));
        document.addPage(pdf.makeIndirectObject(page), false);
    }
}

} // namespace dipwright
