#include "workbench/project/NewProjectDialog.h"

#include "model/ModelFormats.h"
#include "project/FilmSizes.h"
#include "project/ProfileLibrary.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "settings/Immersion.h"
#include "workbench/jobs/Messages.h"
#include "workbench/project/FilmMeasured.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/Units.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>
#include <algorithm>

namespace dipwright {

namespace {

constexpr int readDelay = 300; // ms after the last typed letter
constexpr int dialogWidth = 540, leastHintWidth = dialogWidth - 40; // pixels

enum class Template { One, TopAndBottom, LeftAndRight, Paper };

Immersion immersion(const QString& name, double aboutX, double aboutZ) {
    Immersion made;
    made.name = name;
    made.rotation = {Degrees(aboutX), Degrees(0), Degrees(aboutZ)};
    return made;
}

} // namespace

QStringList pictureFilePatterns() {
    return {QStringLiteral("*.png"), QStringLiteral("*.jpg"),  QStringLiteral("*.jpeg"),
            QStringLiteral("*.bmp"), QStringLiteral("*.webp"), QStringLiteral("*.tif"),
            QStringLiteral("*.tiff")};
}

QString modelFileFilter() {
    return NewProjectDialog::tr("Models (%1)").arg(modelFilePatterns().join(QLatin1Char(' ')));
}

QString pictureFileFilter() {
    return NewProjectDialog::tr("Pictures (%1)").arg(pictureFilePatterns().join(QLatin1Char(' ')));
}

QString projectFileFilter() {
    return NewProjectDialog::tr("Dipwright projects (%1)").arg(QStringLiteral("*.dipw"));
}

NewProjectDialog::NewProjectDialog(const QString& model, const Preferences& preferences,
                                   QWidget* parent)
    : QDialog(parent), lengthUnit_(preferences.unit), printerProfile_(preferences.printerProfile),
      model_(new QLineEdit(model)), texture_(new QLineEdit),
      byUnit_(new QRadioButton(tr("One unit of the file is"))), unit_(new QComboBox),
      byEdge_(new QRadioButton(tr("The largest dimension is"))), edge_(new NumberBox),
      film_(new QComboBox), filmProfile_(new QComboBox), template_(new QComboBox),
      extent_(new QLabel) {
    setWindowTitle(tr("New project"));
    setObjectName(QStringLiteral("newProjectDialog"));
    setMinimumWidth(dialogWidth);
    model_->setPlaceholderText(tr("Choose a model file"));
    model_->setAccessibleName(tr("Model"));
    texture_->setAccessibleName(tr("Texture"));
    model_->setToolTip(tr("The model file of the part to dip: %1.").arg(modelFormatNames()));
    texture_->setPlaceholderText(tr("The model's own texture"));
    texture_->setToolTip(tr("A picture that replaces the model's own texture. Leave it empty to "
                            "keep the model's texture."));
    for (const QString& name : filmSizeNames()) {
        film_->addItem(name);
    }
    film_->setCurrentText(preferences.filmPreset);
    film_->setToolTip(tr("The size of the film as it is delivered and printed."));
    addFilmProfiles(*filmProfile_, preferences.filmProfile);
    filmProfile_->setObjectName(QStringLiteral("filmProfile"));
    filmProfile_->setMinimumContentsLength(30);
    filmProfile_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    filmProfile_->setToolTip(
        tr("The measured properties of the film: how it swells, grows and tears."));
    template_->addItem(tr("One dip"), int(Template::One));
    template_->addItem(tr("Two dips: bottom and top"), int(Template::TopAndBottom));
    template_->addItem(tr("Two dips: left and right"), int(Template::LeftAndRight));
    template_->addItem(tr("One dip with the film model of the 2020 paper, for comparison"),
                       int(Template::Paper));
    template_->setToolTip(
        tr("How many times the part is dipped, and from which sides. You can change this later."));

    auto* form = new QFormLayout;
    form->setVerticalSpacing(10);
    form->addRow(tr("&Model"), makeFileRow(model_, tr("Choose a model"), modelFileFilter()));
    form->addRow(tr("Te&xture"),
                 makeFileRow(texture_, tr("Choose a texture"), pictureFileFilter()));
    form->addRow(tr("Size"), makeSizeRow());
    extent_->setObjectName(QStringLiteral("extent"));
    extent_->setWordWrap(true);
    extent_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    extent_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form->addRow(extent_);
    form->addRow(tr("Film &profile"), filmProfile_);
    form->addRow(tr("&Film"), film_);
    form->addRow(tr("&Dips"), template_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    create_ = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    create_->setDefault(true);
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    createAndRun_ = buttons->addButton(tr("Create and &run"), QDialogButtonBox::AcceptRole);
    createAndRun_->setObjectName(QStringLiteral("createAndRun"));
    createAndRun_->setToolTip(tr("Creates the project and simulates its dips at once."));
    connect(buttons, &QDialogButtonBox::clicked, this,
            [this](QAbstractButton* button) { runs_ = button == createAndRun_; });
    connect(buttons, &QDialogButtonBox::accepted, this, &NewProjectDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch();
    layout->addSpacing(12);
    layout->addWidget(buttons);
    delay_.setSingleShot(true);
    delay_.setInterval(readDelay);
    connect(&delay_, &QTimer::timeout, this, &NewProjectDialog::readSizes);
    connect(model_, &QLineEdit::textChanged, this, &NewProjectDialog::updateButtons);
    connect(texture_, &QLineEdit::textChanged, this, &NewProjectDialog::updateButtons);
    updateButtons();
}

QWidget* NewProjectDialog::makeFileRow(QLineEdit* line, const QString& title,
                                       const QString& filter) {
    auto* browse = new QToolButton;
    browse->setIcon(icon(QStringLiteral("document-open")));
    browse->setToolTip(title);
    browse->setAccessibleName(title);
    connect(browse, &QToolButton::clicked, this, [this, line, title, filter] {
        const QString path = QFileDialog::getOpenFileName(
            this, title, QFileInfo(model_->text()).absolutePath(), filter);
        if (!path.isEmpty()) {
            line->setText(path);
        }
    });
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(line, 1);
    layout->addWidget(browse);
    row->setFocusProxy(line);
    return row;
}

QWidget* NewProjectDialog::makeSizeRow() {
    unit_->addItem(tr("a millimetre"), 1.0);
    unit_->addItem(tr("a centimetre"), 10.0);
    unit_->addItem(tr("a metre"), 1000.0);
    unit_->addItem(tr("an inch"), millimetresPerInch);
    const double factor = shownPerStored(Unit::Length, lengthUnit_);
    edge_->setRange(1 * factor, 3000 * factor);
    edge_->setDecimals(unitDecimals(Unit::Length, lengthUnit_));
    edge_->setSuffix(unitSuffix(Unit::Length, lengthUnit_));
    edge_->setValue(90 * factor);
    edge_->setEnabled(false);
    edge_->setAccessibleName(tr("Largest dimension"));
    edge_->setToolTip(
        tr("Scales the model so that its largest dimension (along X, Y or Z) has this length."));
    byEdge_->setToolTip(edge_->toolTip());
    unit_->setAccessibleName(tr("Unit of the file"));
    unit_->setToolTip(
        tr("The unit of the coordinates in the model file. The file itself does not state it."));
    byUnit_->setToolTip(unit_->toolTip());
    byUnit_->setChecked(true);
    connect(byEdge_, &QRadioButton::toggled, edge_, &QWidget::setEnabled);
    connect(byUnit_, &QRadioButton::toggled, unit_, &QWidget::setEnabled);
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(byUnit_, 0, 0);
    grid->addWidget(unit_, 0, 1);
    grid->addWidget(byEdge_, 1, 0);
    grid->addWidget(edge_, 1, 1);
    grid->setColumnStretch(1, 1);
    connect(edge_, &QDoubleSpinBox::valueChanged, this, &NewProjectDialog::showExtent);
    connect(byEdge_, &QRadioButton::toggled, this, &NewProjectDialog::showExtent);
    connect(unit_, &QComboBox::currentIndexChanged, this, &NewProjectDialog::showExtent);
    const auto choose = [this] {
        guesses_ = false;
        showExtent();
    };
    connect(unit_, &QComboBox::activated, this, choose);
    connect(byEdge_, &QRadioButton::clicked, this, [this, choose] {
        edge_->setFocus(); // so that the length can be typed at once
        edge_->selectAll();
        choose();
    });
    connect(byUnit_, &QRadioButton::clicked, this, choose);
    return box;
}

void NewProjectDialog::updateButtons() {
    jobs_.cancelAll();
    const bool isThere = QFileInfo(model_->text()).isFile();
    enableCreate(isThere);
    reading_ = isThere ? Reading::Pending : Reading::Done;
    isAccepting_ = false;
    failure_.clear();
    sizes_.reset();
    showExtent();
    delay_.start();
}

// Reads the model, as a check and for its sizes in the file's units.
void NewProjectDialog::readSizes() {
    jobs_.cancelAll();
    const QString path = model_->text();
    if (!QFileInfo(path).isFile()) {
        reading_ = Reading::Done;
        enableCreate(false);
        return;
    }
    reading_ = Reading::Pending;
    failure_.clear();
    showHint(tr("Reading the model …"));
    ImportOptions options;
    options.texture = texture_->text();
    jobs_.start(std::make_unique<ValueJob<ImportedModel>>(
        tr("Reading the model"),
        [path, options](const Progress& progress) { return importModel(path, options, progress); },
        [this, path](const ImportedModel& imported) {
            namesUnit_ = namesUnit(path);
            takeSizes(imported.report.box);
            if (!proposeTexture(imported)) {
                endReading({});
            }
        },
        [this](const std::exception_ptr& failure) {
            try {
                std::rethrow_exception(failure);
            } catch (const OutsideFiles&) { // asked about when the project is created
                endReading({});
            } catch (...) {
                endReading(sentenceOf(failure));
            }
        }));
}

// If the model has no texture, but could have one, and there is one picture that it can be,
// proposes this picture: the one with the model's name, else the only one in the model's folder.
bool NewProjectDialog::proposeTexture(const ImportedModel& imported) {
    const QFileInfo model(model_->text());
    const auto hasCoordinates = [&mesh = imported.model] {
        for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
            if (mesh.hasTextureCoordinates(t)) {
                return true;
            }
        }
        return false;
    };
    if (!texture_->text().isEmpty() || proposed_ == model.filePath() ||
        !imported.model.textures.empty() || !hasCoordinates()) {
        return false;
    }
    proposed_ = model.filePath(); // proposed once, so that the user can clear it
    const QFileInfoList all = model.absoluteDir().entryInfoList(pictureFilePatterns(), QDir::Files);
    QFileInfoList named = all;
    named.removeIf([&](const QFileInfo& picture) {
        return picture.completeBaseName().compare(model.completeBaseName(), Qt::CaseInsensitive) !=
               0;
    });
    const QFileInfoList& found = named.isEmpty() ? all : named;
    if (found.size() != 1) {
        return false;
    }
    const bool wasAccepting = isAccepting_;
    texture_->setText(found.first().absoluteFilePath());
    isAccepting_ = wasAccepting;
    enableCreate(!wasAccepting);
    return true;
}

void NewProjectDialog::enableCreate(bool enabled) {
    create_->setEnabled(enabled);
    createAndRun_->setEnabled(enabled);
}

// `failure`: why the model cannot be read; empty: it can.
void NewProjectDialog::endReading(const QString& failure) {
    reading_ = Reading::Done;
    failure_ = failure;
    enableCreate(true);
    showExtent();
    if (isAccepting_ && failure.isEmpty()) {
        QDialog::accept();
    }
    isAccepting_ = false;
}

// A model that cannot be read leaves the dialog open, with its values.
void NewProjectDialog::accept() {
    if (reading_ == Reading::Done && failure_.isEmpty()) {
        QDialog::accept();
        return;
    }
    isAccepting_ = true;
    enableCreate(false);
    if (reading_ == Reading::Done || delay_.isActive()) { // perhaps the file has been repaired
        delay_.stop();
        readSizes();
    }
}

// Makes the label as tall as its text, and at least two lines, so that the fields below stay in
// place.
void NewProjectDialog::showHint(const QString& text) {
    extent_->setText(text);
    const int twoLines = 2 * extent_->fontMetrics().lineSpacing();
    extent_->setMinimumHeight(
        std::max(twoLines, extent_->heightForWidth(std::max(extent_->width(), leastHintWidth))));
}

void NewProjectDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    showHint(extent_->text());
}

void NewProjectDialog::takeSizes(const BoundingBox& box) {
    sizes_ = box.sizes().cast<double>();
    if (guesses_) {
        unit_->setCurrentIndex(unit_->findData(namesUnit_ ? 1.0 : guessedUnit(sizes_->maxCoeff())));
    }
    showExtent();
}

void NewProjectDialog::showExtent() {
    if (!failure_.isEmpty()) {
        showHint(QStringLiteral("⚠ ") + failure_);
        return;
    }
    if (!sizes_) {
        showHint({});
        return;
    }
    const ImportOptions options = importOptions();
    const Eigen::Vector3d size =
        *sizes_ * (options.longestEdge ? options.longestEdge->value() / sizes_->maxCoeff()
                                       : options.unitMillimetres);
    const QString text =
        tr("The part measures %1 × %2 × %3")
            .arg(shownLength(size.x(), lengthUnit_), shownLength(size.y(), lengthUnit_),
                 shownLength(size.z(), lengthUnit_));
    showHint(guesses_ && byUnit_->isChecked() && !namesUnit_
                 ? text + QStringLiteral("; ") + tr("the unit was guessed from the size.")
                 : text + QStringLiteral("."));
}

QString NewProjectDialog::model() const {
    return model_->text();
}

ImportOptions NewProjectDialog::importOptions() const {
    ImportOptions options;
    options.texture = texture_->text();
    if (byEdge_->isChecked()) {
        options.longestEdge =
            Millimetres(edge_->value() / shownPerStored(Unit::Length, lengthUnit_));
    } else {
        options.unitMillimetres = unit_->currentData().toDouble();
    }
    return options;
}

std::function<void(Project&)> NewProjectDialog::completion() const {
    return [film = film_->currentText(), filmProfile = filmProfile_->currentData().toString(),
            printer = printerProfile_,
            chosen = Template(template_->currentData().toInt())](Project& project) {
        const ProfileLibrary profiles;
        for (const auto& [kind, name] : {std::pair(ProfileKind::Film, filmProfile),
                                         std::pair(ProfileKind::Printer, printer)}) {
            if (const auto profile = profiles.found(kind, name)) {
                applyProfile(project, *profile);
            }
        }
        const QSizeF size = filmSize(film); // overrides the size in the profile
        resizeFilm(project.film, Millimetres(size.width()), Millimetres(size.height()));
        switch (chosen) {
        case Template::One:
            break;
        case Template::TopAndBottom:
            project.immersions = {immersion(tr("Bottom"), 0, 0), immersion(tr("Top"), 180, 0)};
            break;
        case Template::LeftAndRight:
            project.immersions = {immersion(tr("Left"), 0, 90), immersion(tr("Right"), 0, -90)};
            break;
        case Template::Paper:
            applyPreset(project, QStringLiteral("paper-2020"));
            break;
        }
    };
}

} // namespace dipwright
