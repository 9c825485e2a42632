/** What help says of options in French. */
import type { Words } from '../words.js';

export const optionHelp: Words['optionHelp'] = {
  parts: 'nombre de parties',
  nets: 'file\u202f: garder les patrons et les languettes que le fichier apporte (PDO)\u202f; new\u202f: en chercher d’autres',
  solver:
    'tree\u202f: recherche locale sur des arbres couvrants\u202f; genetic\u202f: évolution, comme dans la publication',
  heuristic:
    'pour l’apprentissage\u202f: steepest (arêtes raides), flat (plat), hybrid (les deux) ou random (hasard)',
  segment: 'merge\u202f: dépliabilité et forme\u202f; spectral\u202f: dépliabilité seule',
  runs: 'essais d’apprentissage',
  proxy: 'apprendre sur une copie plus simple au-dessus de N faces\u202f; 0\u202f: jamais',
  seed: 'la même graine donne le même résultat',
  faces: 'simplifier d’abord à N triangles',
  repair:
    'étapes de la réparation à faire ou non, comme weld=off ou cracks=off\u202f; peut être donné plusieurs fois',
  'fill-holes':
    'boucher les trous larges au plus de ce pourcentage du plus long côté du modèle\u202f; all\u202f: tous',
  inside:
    'les corps placés à l’intérieur d’autres\u202f: keep\u202f: les garder\u202f; drop\u202f: les laisser de côté',
  crossing:
    'les corps qui se traversent\u202f: keep\u202f: les garder\u202f; unite\u202f: les réunir',
  folding:
    'patrons sans façon de les plier\u202f: require\u202f: diviser\u202f; prefer\u202f: signaler\u202f; off\u202f: ne pas chercher',
  clearance: 'distance entre les faces pendant le pliage, en longueurs moyennes d’arête',
  height:
    'hauteur finie, du bas vers le haut\u202f; les pièces trop grandes pour la feuille sont recoupées',
  width: 'largeur finie\u202f: le long de x, ou de y si x est vers le haut',
  depth: 'profondeur finie\u202f: le long de z, ou de y si z est vers le haut',
  up: 'axe du fichier dirigé vers le haut\u202f: x, y ou z\u202f; guess\u202f: z pour STL, sinon y',
  scale: 'taille finie, comme facteur sur la taille dans l’unité du modèle',
  sheets: 'aussi grand qu’il tient sur N feuilles',
  unit: 'unité du modèle\u202f: mm, cm, m ou in',
  paper: 'A2 à A5, Letter, Legal, Tabloid, 12x12in, ou LxH en mm',
  orientation: 'auto, portrait ou landscape (paysage)',
  margin: 'marge qui reste libre',
  flaps: 'hauteur des languettes\u202f; plus basses là où la place manque',
  'flap-angle': 'angle de leurs côtés à la base, au maximum',
  'flap-style':
    'languettes le long des courbes douces\u202f: edge\u202f: chacune comme les autres\u202f; run\u202f: une bande à crans étroits\u202f; zigzag\u202f: des dents pointues',
  'flap-side':
    'one\u202f: le côté qui a plus de place\u202f; alternate\u202f: en alternance\u202f; both\u202f: les deux',
  'flap-borders': 'on\u202f: les bords ouverts du modèle ont aussi des languettes',
  'glue-strips':
    'bandes séparées pour les arêtes sans languette\u202f: none\u202f: aucune\u202f; free\u202f: là où les feuilles ont la place\u202f; all\u202f: aussi sur d’autres feuilles',
  ids: 'place des numéros des arêtes coupées\u202f: sur les faces (inside), les languettes (flap) ou les deux (both), sur les languettes et les chutes (outside), ou nulle part (none)',
  'min-piece': 'les corps du modèle plus petits ne sont pas imprimés, mais signalés',
  compact:
    'on\u202f: patrons avec de la place pour les languettes, de petits contours et des passages solides\u202f; off\u202f: comme ils ont été trouvés',
  workers:
    'fils d’exécution\u202f; auto\u202f: un par cœur, au maximum 4\u202f; tout nombre donne le même résultat',
  lang: 'langue de tous les mots\u202f: dans l’aide et les messages, et sur les feuilles',
  'flat-fold': 'les plis plus plats que cela ne sont pas dessinés',
  style: 'aspect des lignes\u202f: foldwright, pepakura ou blender',
  'cut-width': 'largeur des traits de coupe',
  'cut-colour': 'couleur des traits de coupe',
  'mountain-width': 'largeur des plis montagne',
  'mountain-dash': 'tirets et espaces des plis montagne',
  'mountain-colour': 'couleur des plis montagne',
  'valley-width': 'largeur des plis vallée',
  'valley-dash': 'tirets et espaces des plis vallée',
  'valley-colour': 'couleur des plis vallée',
  'flap-colour': 'remplissage des languettes',
  'fold-ticks':
    'on\u202f: les plis sont des repères de 3 mm aux deux bouts, ou un tiers du pli, au lieu de lignes à travers l’image',
  duplex:
    'on\u202f: derrière chaque feuille, une page avec ses plis en miroir, à imprimer en recto verso, en tournant sur le bord long (PDF)',
  'fold-angles': 'imprimer à côté des plis leur angle de pliage',
  thickness: 'épaisseur du papier\u202f: les languettes se plient là où vient son dos',
  legend: 'imprimer une fois ce que veulent dire les lignes et les numéros',
  assembly:
    'on\u202f: des pages avec une couverture, une liste des pièces et les étapes pour construire le modèle (PDF, SVG, PNG)',
  measured:
    'ce que mesurent les règles imprimées de 50 mm, en largeur et en hauteur\u202f: corrige l’échelle de l’imprimante',
  machine:
    'pour une découpeuse\u202f: lignes à couper, rainer et dessiner en couleurs pures\u202f; none\u202f: pour des ciseaux',
  dpi: 'pixels par pouce des fichiers PNG, et des couleurs et images du modèle dans tous les fichiers',
  texture:
    'imprimer les faces aux couleurs et avec les images du modèle\u202f; auto\u202f: là où il en a, sans --colour part',
  colour:
    'part\u202f: imprimer chaque pièce dans la couleur de sa partie, sauf si --texture on en trouve dans le modèle',
  shading:
    'on\u202f: imprimer les ombres et lumières de la surface, pour un modèle simplifié celles d’avant, pour voir les détails sans les plier',
  'flap-bleed':
    'ce qui, d’une languette, reçoit les couleurs de sa face\u202f: none (rien), half (la moitié) ou whole (tout)',
};
