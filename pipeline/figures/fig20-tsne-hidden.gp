# Fig. 20: t-SNE of the last hidden layer.
# height: 760
heading = "Test windows as the classifier's last hidden layer sees them (t-SNE)"
load scripts.'/tsne.gp'
