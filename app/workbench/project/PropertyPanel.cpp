#include "workbench/project/PropertyPanel.h"

#include "base/Error.h"
#include "geometry/Solid.h"
#include "import/trusted/CadFacts.h"
#include "model/NamedMaterials.h"
#include "pipeline/DeeperDip.h"
#include "pipeline/JobSheet.h"
#include "project/CadModel.h"
#include "project/Profiles.h"
#include "workbench/accuracy/ZoneFields.h"
#include "workbench/document/ImmersionEdits.h"
#include "workbench/document/ModelEdits.h"
#include "workbench/document/ProjectValue.h"
#include "workbench/jobs/SolverListing.h"
#include "workbench/project/MaskFields.h"
#include "workbench/project/PathKeyFields.h"
#include "workbench/project/PropertySpecs.h"
#include "workbench/project/SeamFields.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/ShippedNames.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

namespace dipwright {

namespace {

constexpr int leastWidth = 290;
constexpr int leastField = 90; // beside its label, pixels

// Names by which the user can mark surface; none if there is no choice.
QStringList namesOn(const TexturedMesh& model) {
    const QStringList names = materialNames(model);
    return names.size() > 1 ? names : QStringList();
}

} // namespace

PropertyPanel::PropertyPanel(const SolverRegistry& registry, QWidget* parent)
    : QScrollArea(parent), registry_(registry) {
    setObjectName(QStringLiteral("propertyPanel"));
    setAccessibleName(tr("Properties"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void PropertyPanel::setDocument(Document* document) {
    document_ = document;
    if (document) {
        connect(document, &Document::projectChanged, this, &PropertyPanel::refresh);
    }
    rebuild();
}

void PropertyPanel::setLengthUnit(LengthUnit unit) {
    lengthUnit_ = unit;
    rebuild();
}

void PropertyPanel::showNode(const ProjectNode& node) {
    if (node != node_) {
        node_ = node;
        rebuild();
    }
}

void PropertyPanel::rebuild() {
    setProperty("part", int(node_.part)); // tells the guide where to open
    refreshers_.clear();
    emit brushChanged({});
    emit pathKeyChosen(-1);
    emit shownPrintChanged({});
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(10, 8, 10, 10);
    form->setVerticalSpacing(8);
    // If the form wrapped rows by itself, Qt 6.4 would lay out other rows with no height as long as
    // the form has hidden rows. addField() puts wide fields below their labels.
    form->setRowWrapPolicy(QFormLayout::DontWrapRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    if (document_) {
        if (node_.part == ProjectPart::Model) {
            addModelFacts(*form);
        } else if (node_.part == ProjectPart::Process) {
            addPreset(*form);
            addSolver(*form);
        } else if (node_.part == ProjectPart::Film) {
            addProfile(*form, ProfileKind::Film, tr("Film profile"),
                       tr("The measured values of one film: size, swell, relaxation and sides."));
            addProfile(*form, ProfileKind::Tank, tr("Tank profile"),
                       tr("The values of one tank. Its barriers hold the sides of the film."));
        } else if (node_.part == ProjectPart::Sheet) {
            addProfile(*form, ProfileKind::Printer, tr("Printer profile"),
                       tr("The measured values of one printer: scale, margins, colours, ink limit "
                          "and resolution."));
        }
        for (const PropertySection& section : propertySections(node_)) {
            addSection(*form, section);
        }
    }
    if (document_ && node_.part == ProjectPart::Model) {
        addMaskFields(*form);
    }
    if (document_ && node_.part == ProjectPart::Immersion) {
        addPathKeys(*form);
    }
    if (document_ && node_.part == ProjectPart::Share) {
        addSeamFields(*form);
        addPrintFields(*form);
    }
    if (document_ && node_.part == ProjectPart::Tolerance) {
        addZoneFields(*form);
        addTolerancesButton(*form);
    }
    setWidget(page);
    refresh();
    // Nothing may be cut off at the side: the panel scrolls only vertically.
    const int least = std::max(leastWidth, page->minimumSizeHint().width() +
                                               verticalScrollBar()->sizeHint().width());
    emit leastWidthChanging(least);
    setMinimumWidth(least);
}

void PropertyPanel::showField(const QString& path) {
    for (PropertyField* field : widget()->findChildren<PropertyField*>()) {
        if (field->spec().path == path) {
            widget()->layout()->activate(); // the field may be new
            field->setFocus(Qt::ShortcutFocusReason);
            ensureWidgetVisible(field);
        }
    }
}

void PropertyPanel::refresh() {
    if (!document_) {
        return;
    }
    if (node_.part == ProjectPart::Immersion &&
        node_.immersion >= document_->project().immersions.size()) {
        return; // the tree will select another node
    }
    for (const auto& refresher : refreshers_) {
        refresher();
    }
}

void PropertyPanel::addSection(QFormLayout& form, const PropertySection& section) {
    if (!section.title.isEmpty()) {
        QWidget* heading = addHeading(form, section.title);
        refreshers_.push_back([this, &form, heading, specs = section.specs] {
            form.setRowVisible(heading, std::ranges::any_of(specs, [this](const auto& spec) {
                                   return !spec.relevant || spec.relevant(document_->project());
                               }));
        });
    }
    for (const PropertySpec& spec : section.specs) {
        addField(form, spec);
        if (spec.path == QLatin1String("film.points")) {
            addFilmFacts(form);
        }
    }
}

QWidget* PropertyPanel::addHeading(QFormLayout& form, const QString& text) {
    auto* heading = new QLabel(text);
    QFont font = heading->font();
    font.setBold(true);
    heading->setFont(font);
    heading->setWordWrap(true);
    heading->setContentsMargins(0, form.rowCount() > 0 ? 8 : 0, 0, 0);
    form.addRow(heading);
    return heading;
}

void PropertyPanel::addField(QFormLayout& form, const PropertySpec& spec) {
    PropertyField* field = PropertyField::make(spec, valueRule(spec.path), lengthUnit_, nullptr);
    auto* label = new QLabel(spec.label);
    label->setBuddy(field);
    label->setToolTip(spec.help);
    QWidget* row = field;
    // These fields need the panel's whole width.
    constexpr qsizetype longWord = 18; // letters of a choice that leave no room for the label
    const bool hasLongWord =
        std::any_of(spec.words.cbegin(), spec.words.cend(),
                    [](const QString& word) { return word.size() > longWord; });
    constexpr int room = leastWidth - 50; // without margins, spacing and scroll bar
    const bool isWide =
        label->sizeHint().width() + std::max(field->minimumSizeHint().width(), leastField) > room;
    if (spec.parts.size() > 1 || !spec.absent.isEmpty() || hasLongWord || isWide) {
        label->setWordWrap(true);
        row = new QWidget;
        auto* stack = new QVBoxLayout(row);
        stack->setContentsMargins(0, 0, 0, 0);
        stack->setSpacing(4);
        stack->addWidget(label);
        stack->addWidget(field);
        form.addRow(row);
    } else {
        form.addRow(label, field);
    }
    connect(field, &PropertyField::edited, this, [this, spec, field](const QJsonValue& value) {
        edit(tr("Change %1").arg(spec.label), spec.path, [&](Project& project) {
            setValueAt(project, spec.path, value);
            fillPoses(project, document_->project());
        });
        field->show(valueAt(document_->project(), spec.path));
    });
    connect(field, &PropertyField::refused, this, &PropertyPanel::failed);
    connect(field, &PropertyField::left, this, [this] {
        if (document_) {
            document_->endMerge();
        }
    });
    refreshers_.push_back([this, &form, row, field, spec] {
        field->show(valueAt(document_->project(), spec.path));
        if (spec.relevant) {
            form.setRowVisible(row, spec.relevant(document_->project()));
        }
    });
}

void PropertyPanel::edit(const QString& text, const QString& mergeKey,
                         const std::function<void(Project&)>& change) {
    try {
        document_->edit(text, mergeKey, [&](Project& project) {
            change(project);
            checkEditedSpots(document_->project(), project);
        });
        emit edited();
    } catch (const Error& error) {
        emit failed(error.sentence());
        refresh();
    }
}

void PropertyPanel::addModelFacts(QFormLayout& form) {
    auto* facts = new QLabel;
    facts->setWordWrap(true);
    facts->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    form.addRow(facts);
    refreshers_.push_back([this, facts] {
        const Project& project = document_->project();
        const TexturedMesh& model = *project.model;
        const Eigen::Vector3f size = boundingBox(model.mesh).sizes();
        const QLocale locale;
        QStringList lines{
            project.modelOrigin.source.isEmpty()
                ? tr("Embedded in the project")
                : tr("Read from %1").arg(QFileInfo(project.modelOrigin.source).fileName()),
            tr("Size: %1 × %2 × %3")
                .arg(shownLength(size.x(), lengthUnit_), shownLength(size.y(), lengthUnit_),
                     shownLength(size.z(), lengthUnit_)),
            tr("Triangles: %1").arg(locale.toString(qulonglong(model.mesh.triangles.size()))),
            tr("Volume: %1 cm³").arg(locale.toString(volume(model.mesh) / 1000, 'f', 1)),
            boundsSolid(model.mesh) ? tr("Closed surface") : tr("Surface with openings")};
        for (const QImage& texture : model.textures) {
            lines.append(
                tr("Texture of %1 × %2 pixels").arg(texture.width()).arg(texture.height()));
        }
        if (model.textures.empty()) {
            lines.append(tr("No texture (drop a picture on the window to add one)"));
        }
        if (const QString cad = cadText(project); !cad.isEmpty()) {
            lines.append(cad);
        }
        if (const QString notes = project.modelOrigin.notes(); !notes.isEmpty()) {
            lines.append(notes);
        }
        facts->setText(lines.join(QLatin1Char('\n')));
    });
    addModelSize(form);
    addTessellation(form);
    const auto addButton = [this, &form](const QString& iconName, const QString& text,
                                         const QString& help, void (PropertyPanel::*asked)()) {
        auto* button = new QPushButton(icon(iconName), text);
        button->setToolTip(help);
        connect(button, &QPushButton::clicked, this, asked);
        form.addRow(button);
    };
    addButton(QStringLiteral("reload"), tr("Reload from disk"),
              tr("Reads the model's file again and keeps all settings."),
              &PropertyPanel::reloadModelAsked);
    addButton(QStringLiteral("replace"), tr("Replace model…"),
              tr("Loads another model. Rotations and offsets are reset."),
              &PropertyPanel::replaceModelAsked);
    addButton(QStringLiteral("texture"), tr("Replace texture…"),
              tr("Replaces the texture of the model with another picture."),
              &PropertyPanel::replaceTextureAsked);
}

void PropertyPanel::addModelSize(QFormLayout& form) {
    auto* edge = new NumberBox;
    const double shown = shownPerStored(Unit::Length, lengthUnit_);
    edge->setObjectName(QStringLiteral("modelSize"));
    edge->setAccessibleName(tr("Largest dimension"));
    edge->setDecimals(unitDecimals(Unit::Length, lengthUnit_));
    edge->setRange(leastLongestEdge.value() * shown, mostLongestEdge.value() * shown);
    edge->setSuffix(unitSuffix(Unit::Length, lengthUnit_));
    edge->setKeyboardTracking(false);
    edge->setToolTip(tr("Scales the model, with the marks on it, so that its largest dimension "
                        "(along X, Y or Z) has this length."));
    form.addRow(tr("Largest dimension"), edge);
    connect(edge, &QDoubleSpinBox::valueChanged, this,
            [this, shown](double value) { resizeModel(*document_, Millimetres(value / shown)); });
    connect(edge, &QDoubleSpinBox::editingFinished, this, [this] {
        if (document_) {
            document_->endMerge();
        }
    });
    refreshers_.push_back([this, edge, shown] {
        const QSignalBlocker quiet(edge);
        edge->setValue(longestEdgeOf(document_->project().model->mesh) * shown);
    });
}

void PropertyPanel::addTessellation(QFormLayout& form) {
    constexpr int decimals = 3; // in mm, in which CAD programs state it
    auto* tolerance = new NumberBox;
    tolerance->setObjectName(QStringLiteral("tessellation"));
    tolerance->setAccessibleName(tr("Tolerance of triangles"));
    tolerance->setDecimals(decimals);
    tolerance->setRange(finestTessellation, coarsestTessellation);
    tolerance->setSingleStep(0.01);
    tolerance->setSuffix(unitSuffix(Unit::Length, LengthUnit::Millimetre));
    tolerance->setKeyboardTracking(false);
    tolerance->setToolTip(
        tr("The largest distance of the triangles from the surfaces of the CAD file. A smaller one "
           "shows curves more exactly and makes more triangles. Usual: 0.005 to 0.1 mm. Zones, "
           "masks and artwork stay."));
    form.addRow(tr("Tolerance of triangles"), tolerance);
    connect(tolerance, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (Millimetres(value) != document_->project().modelOrigin.tessellation) {
            emit tessellationAsked(Millimetres(value));
        }
    });
    refreshers_.push_back([this, &form, tolerance] {
        const Project& project = document_->project();
        const QSignalBlocker quiet(tolerance);
        tolerance->setValue(project.modelOrigin.tessellation.value());
        form.setRowVisible(tolerance, !project.cad.name.isEmpty());
    });
}

void PropertyPanel::addFilmFacts(QFormLayout& form) {
    auto* facts = new QLabel;
    facts->setObjectName(QStringLiteral("filmFacts"));
    facts->setWordWrap(true);
    facts->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    form.addRow(facts);
    refreshers_.push_back([this, facts] {
        facts->setText(
            filmFacts_.text(document_->project(), document_->result().get(), lengthUnit_));
    });
}

template <typename Mark>
void PropertyPanel::addMarkFields(QFormLayout& form, const QString& heading, MarkFields& fields) {
    addHeading(form, heading);
    form.addRow(&fields);
    connect(&fields, &MarkFields::changed, this,
            [this, &fields] { emit brushChanged(fields.brush()); });
    connect(&fields, &MarkFields::nameChosen, this, [this, &fields](const QString& name) {
        markByName(materialBrush(fields.brush()), name);
    });
    connect(&fields, &MarkFields::removeLastAsked, this,
            [this] { removeLastMark<Mark>(*document_); });
    connect(&fields, &MarkFields::removeAllAsked, this, [this] { removeMarks<Mark>(*document_); });
}

void PropertyPanel::markByName(const MarkBrush& brush, const QString& name) {
    const std::optional<Eigen::Vector3f> middle =
        middleOfMaterial(*document_->project().model, name);
    if (!middle) {
        return;
    }
    std::array<Millimetres, 3> place;
    for (int axis = 0; axis < 3; ++axis) {
        place[std::size_t(axis)] = Millimetres(std::round(double((*middle)[axis]) * 1000) / 1000);
    }
    try {
        addMark(*document_, brush, place, name);
    } catch (const Error& error) {
        emit failed(error.sentence());
    }
}

void PropertyPanel::addSeamFields(QFormLayout& form) {
    auto* fields = new SeamFields(lengthUnit_);
    addMarkFields<ShareMark>(form, tr("Marks for the seam"), *fields);
    refreshers_.push_back([this, fields] {
        const Project& project = document_->project();
        if (project.immersions.size() > 1) {
            fields->setDips(project.immersions[0].name, project.immersions[1].name);
        }
        fields->setEnabled(project.share.enabled);
        fields->setMarkCount(project.share.marks.size());
    });
}

void PropertyPanel::addPathKeys(QFormLayout& form) {
    auto* fields = new PathKeyFields(lengthUnit_);
    form.addRow(fields);
    const std::size_t dip = node_.immersion;
    connect(fields, &PathKeyFields::changed, this, [this, dip](const std::vector<PathKey>& keys) {
        edit(tr("Change poses of path"), QStringLiteral("path keys"),
             [&](Project& project) { project.immersions[dip].path.keys = keys; });
    });
    connect(fields, &PathKeyFields::addAsked, this, [this, dip, fields](int before) {
        addPathKey(*document_, dip, std::size_t(before));
        fields->choose(before + 1);
    });
    connect(fields, &PathKeyFields::removeAsked, this,
            [this, dip](int key) { removePathKey(*document_, dip, std::size_t(key)); });
    connect(fields, &PathKeyFields::chosen, this, &PropertyPanel::pathKeyChosen);
    connect(fields, &PathKeyFields::refused, this, &PropertyPanel::failed);
    connect(fields, &PathKeyFields::left, this, [this] {
        if (document_) {
            document_->endMerge();
        }
    });
    refreshers_.push_back([this, &form, fields, dip] {
        const DipPath& path = document_->project().immersions[dip].path;
        const bool isShown = path.kind == PathKind::Poses && path.keys.size() >= 2;
        fields->show(isShown ? path.keys : std::vector<PathKey>(),
                     isShown ? depthOf(document_->project(), dip) : Millimetres(0));
        form.setRowVisible(fields, isShown);
    });
}

void PropertyPanel::addZoneFields(QFormLayout& form) {
    auto* fields = new ZoneFields(lengthUnit_);
    addMarkFields<ZoneMark>(form, tr("Zones on the part"), *fields);
    refreshers_.push_back([this, fields] {
        fields->setMarkCount(document_->project().tolerance.marks.size());
        fields->setNames(namesOn(*document_->project().model));
    });
}

void PropertyPanel::addMaskFields(QFormLayout& form) {
    auto* fields = new MaskFields(lengthUnit_);
    addMarkFields<MaskMark>(form, tr("Masks on the part"), *fields);
    refreshers_.push_back([this, fields] {
        fields->setMarkCount(document_->project().masks.size());
        fields->setNames(namesOn(*document_->project().model));
    });
}

void PropertyPanel::addTolerancesButton(QFormLayout& form) {
    auto* tell = new QPushButton(icon(QStringLiteral("tolerance")), tr("Compute tolerances…"));
    tell->setObjectName(QStringLiteral("tellTolerances"));
    tell->setToolTip(tr("Simulates dips with the expected deviations, each alone and all at once. "
                        "Shows how far the colours land from their intended places."));
    connect(tell, &QPushButton::clicked, this, &PropertyPanel::tolerancesAsked);
    form.addRow(tell);
}

void PropertyPanel::addPrintFields(QFormLayout& form) {
    addHeading(form, tr("Print with a misplaced second film"));
    auto* note = new QLabel(
        tr("To see it, choose “Finished part” in the 3D view. The sheets do not change."));
    note->setWordWrap(true);
    form.addRow(note);
    const bool isDippedWhole = !document_->project().process.depth;
    auto* fields = new PrintFields(lengthUnit_, isDippedWhole ? Millimetres(0) : mostDeeper);
    form.addRow(fields);
    connect(fields, &PrintFields::changed, this,
            [this, fields] { emit shownPrintChanged(fields->print()); });
    refreshers_.push_back([this, fields] {
        const std::vector<Immersion>& dips = document_->project().immersions;
        if (dips.size() > 1) {
            fields->setDips(dips[0].name, dips[1].name);
        }
    });
}

void PropertyPanel::addPreset(QFormLayout& form) {
    auto* box = new QComboBox;
    box->addItem(tr("Production"), QStringLiteral("production"));
    box->addItem(tr("Model of 2020"), QStringLiteral("paper-2020"));
    box->addItem(tr("Custom"), QString());
    const QString help = tr("Production is the accurate film model and the default. Model of 2020 "
                            "is the published film model, for comparison.");
    box->setToolTip(help);
    box->setWhatsThis(help);
    box->setAccessibleName(tr("Preset"));
    auto* label = new QLabel(tr("Preset"));
    label->setBuddy(box);
    form.addRow(label, box);
    connect(box, &QComboBox::activated, this, [this, box](int index) {
        const QString preset = box->itemData(index).toString();
        if (!preset.isEmpty()) {
            edit(tr("Apply preset"), {},
                 [&preset](Project& project) { applyPreset(project, preset); });
        }
        refresh();
    });
    refreshers_.push_back([this, box] {
        const Project& project = document_->project();
        for (int index = 0; index < box->count(); ++index) {
            const QString preset = box->itemData(index).toString();
            Project applied = project;
            if (!preset.isEmpty()) {
                applyPreset(applied, preset);
            }
            if (applied == project) {
                box->setCurrentIndex(index);
                return;
            }
        }
    });
}

void PropertyPanel::addProfile(QFormLayout& form, ProfileKind kind, const QString& name,
                               const QString& help) {
    auto* box = new QComboBox;
    box->setObjectName(profileKindName(kind) + QStringLiteral("Profile"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    box->setToolTip(help);
    box->setWhatsThis(help);
    box->setAccessibleName(name);
    auto* label = new QLabel(name);
    label->setBuddy(box);
    form.addRow(label, box);
    connect(box, &QComboBox::activated, this, [this, box, kind, name](int index) {
        const QString chosen = box->itemData(index).toString();
        edit(tr("Choose %1").arg(name), {}, [&](Project& project) {
            if (!chosen.isEmpty()) {
                applyProfile(project, profiles_.profile(kind, chosen));
            }
        });
    });
    refreshers_.push_back([this, box, kind] {
        const ProjectProfiles& profiles = document_->project().profiles;
        const QString used = kind == ProfileKind::Film && profiles.film   ? profiles.film->name
                             : kind == ProfileKind::Tank && profiles.tank ? profiles.tank->name
                             : kind == ProfileKind::Printer && profiles.printer
                                 ? profiles.printer->name
                                 : QString();
        box->clear();
        if (used.isEmpty()) {
            box->addItem(tr("None"), QString());
        }
        for (const ProfileEntry& entry : profiles_.profiles(kind)) {
            box->addItem(shownName(entry.name), entry.name);
        }
        if (box->findData(used) < 0) {
            box->addItem(shownName(used), used); // the project's own copy
        }
        box->setCurrentIndex(box->findData(used));
    });
}

void PropertyPanel::listSolvers(QComboBox& box, const std::vector<SolverInfo>& solvers) {
    box.clear();
    box.addItem(tr("Best available"), QStringLiteral("auto"));
    for (const SolverInfo& solver : solvers) {
        const bool mayRun = solver.available || solver.reason.isEmpty(); // true while it is unknown
        const QString name = shownName(solver.name);
        box.addItem(mayRun ? name : tr("%1 (not available)").arg(name), solver.id);
        box.setItemData(box.count() - 1, mayRun ? solver.device : shownName(solver.reason),
                        Qt::ToolTipRole);
    }
}

void PropertyPanel::addSolver(QFormLayout& form) {
    auto* box = new QComboBox;
    box->setObjectName(QStringLiteral("process.solver"));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    const QString help =
        tr("The program that simulates the dip. “Best available” uses a GPU if there is one.");
    box->setToolTip(help);
    box->setWhatsThis(help);
    box->setAccessibleName(tr("Solver"));
    auto* label = new QLabel(tr("Solver"));
    label->setBuddy(box);
    form.addRow(label, box);
    connect(box, &QComboBox::activated, this, [this, box](int index) {
        edit(tr("Choose solver"), {}, [&](Project& project) {
            setValueAt(project, QStringLiteral("process.solver"), box->itemData(index).toString());
        });
    });
    const auto refresh = [this, box] {
        if (!document_) {
            return; // this page is about to be deleted
        }
        const QString id = document_->project().process.solver;
        if (box->findData(id) < 0) {
            box->addItem(tr("%1 (not installed)").arg(id), id);
        }
        box->setCurrentIndex(box->findData(id));
    };
    refreshers_.push_back(refresh);
    const auto show = [box, refresh](const std::vector<SolverInfo>& solvers) {
        listSolvers(*box, solvers);
        refresh();
    };
    new SolverListing(registry_, show, box);
}

} // namespace dipwright
