// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include <QWidget>

#include "lessons/LessonReader.h"
#include "ui/lessoneditor/LessonDraft.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui::lessoneditor {

/// The part of the lesson form for the ideal: its source and its sizes.
class IdealForm final : public QWidget
{
    Q_OBJECT
public:
    explicit IdealForm(QWidget* parent);

    /// Prepares the form for a lesson of this task. offerFields() adds the inputs.
    void begin(::lessons::Task task);
    /// Discards the inputs' labels when the language changes. The inputs must be offered again.
    void forgetWords();
    /// Sets the sources to choose from: the rule, and these captured ideals.
    /// @param present  the source in use; empty: by rule
    void offerReferences(const QStringList& captured, const QString& present);
    /// Sets the inputs. Creates them again only if the fields have changed.
    void offerFields(const std::vector<IdealField>& fields);
    void showValues(const std::vector<IdealField>& fields);
    /// Shows the errors of the ideal beside their inputs. Returns all other errors.
    [[nodiscard]] std::vector<::lessons::ValidationIssue>
    takeFaults(const std::vector<::lessons::ValidationIssue>& faults);
    /// Disables the selection of recordings while recordings are being replayed.
    void setCapturing(bool capturing);

signals:
    void sizeSet(const QString& id, double value);
    /// Emitted when the user has chosen a captured ideal.
    /// @param name  a file in the lesson's folder; empty: by rule
    void referenceChosen(const QString& name);
    void recordingsRequested();

private:
    QWidget* makeInput(const IdealField& field);

    QLabel* m_head = nullptr;
    QComboBox* m_reference = nullptr;
    QPushButton* m_fromRecordings = nullptr;
    QLabel* m_fault = nullptr;
    QVBoxLayout* m_fieldsSlot = nullptr;
    QWidget* m_fields = nullptr;
    std::map<QString, QWidget*> m_inputs;
    std::map<QString, QLabel*> m_faults;
    bool m_isFilling = false;
};

}  // namespace ui::lessoneditor
