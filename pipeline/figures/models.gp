# Whose models are shown, as words for a title: of the two that the paper's outlook names not every run has some.
# Loaded by scripts that show the paper's models.
models = "the paper's models"
do for [method in "piae-dt-tcn piae-dt-transformer"] {
  if (place(method, words_method)) { models = "the paper's models and those of its outlook" }
}
