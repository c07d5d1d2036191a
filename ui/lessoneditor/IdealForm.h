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

/// The part of the lesson editor's form that is about the ideal: what it is taken from, and its numbers.
class IdealForm final : public QWidget
{
    Q_OBJECT
public:
    explicit IdealForm(QWidget* parent);

    /// Begins with a lesson of this task. Its numbers come with offer().
    void begin(::lessons::Task task);
    /// All that it offers was named in another language: it is to be offered again.
    void forgetWords();
    /// What the ideal can be: by rule, or any of these captured ones.
    /// @param present  the one that it is; empty: by rule
    void offerReferences(const QStringList& captured, const QString& present);
    /// Inputs for these numbers. They are made anew only where they are others than before.
    void offerFields(const std::vector<IdealField>& fields);
    void showValues(const std::vector<IdealField>& fields);
    /// Shows what is wrong with the ideal beside what it is about, and answers the rest.
    [[nodiscard]] std::vector<::lessons::ValidationIssue>
    takeFaults(const std::vector<::lessons::ValidationIssue>& faults);
    /// While recordings are replayed no others can be taken.
    void setCapturing(bool capturing);

signals:
    void sizeSet(const QString& id, double value);
    /// @param name  of a file beside the lesson; empty: by rule
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
