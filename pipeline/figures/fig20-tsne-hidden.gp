# Fig. 20: t-SNE of the last hidden layer.
# height: words(words_method) < 5 ? 760 : 113 + 225 * panels(words(words_method), 5)
heading = "Test windows as the classifier's last hidden layer sees them (t-SNE)"
load scripts.'/tsne.gp'
